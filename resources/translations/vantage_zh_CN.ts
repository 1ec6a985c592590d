<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
<context>
    <name>CalibratePage</name>
    <message>
        <source>The table is calibrated.</source>
        <translation>转台已标定。</translation>
    </message>
    <message>
        <source>The table is calibrated, but something about it is in doubt.</source>
        <translation>转台已标定，但其中有存疑之处。</translation>
    </message>
    <message>
        <source>The table could not be calibrated.</source>
        <translation>转台未能标定。</translation>
    </message>
</context>
<context>
    <name>Completeness</name>
    <message>
        <source>Nothing has to be done: it can be printed and measured as it is.</source>
        <translation>无需再做任何事：模型可以直接打印和测量。</translation>
    </message>
    <message>
        <source>Scan on: position %1 would show %2.</source>
        <translation>继续扫描：位置 %1 可显示 %2。</translation>
    </message>
    <message>
        <source>What is open was not seen by these scans: add scans that see it, or close the openings when the model is used.</source>
        <translation>这些扫描没有看到开口处：请添加能看到它的扫描，或在使用模型时封闭开口。</translation>
    </message>
    <message>
        <source>No position of this scanner sees the rest as the object stands: turn it over.</source>
        <translation>按物体现在的摆放，此扫描仪没有任何位置能看到其余部分：请翻转物体。</translation>
    </message>
    <message>
        <source>No position of this scanner sees the rest as the object stands: turn it over, or tilt the scanner.</source>
        <translation>按物体现在的摆放，此扫描仪没有任何位置能看到其余部分：请翻转物体，或倾斜扫描仪。</translation>
    </message>
    <message>
        <source>Little is left that a view would show. Turn the object over to see its underside, or finish.</source>
        <translation>再加视图也看不到多少新内容。请翻转物体以查看底面，或结束。</translation>
    </message>
    <message>
        <source>What is open was not seen: scan on, or turn the object over.</source>
        <translation>开口处尚未被看到：请继续扫描，或翻转物体。</translation>
    </message>
    <message>
        <source>The surface is closed.</source>
        <translation>表面已封闭。</translation>
    </message>
    <message>
        <source>%1 of what the scanner reaches is covered.</source>
        <translation>扫描仪可及部分已覆盖 %1。</translation>
    </message>
    <message>
        <source>The surface has 1 opening.</source>
        <translation>表面有 1 个开口。</translation>
    </message>
    <message>
        <source>The surface has %1 openings.</source>
        <translation>表面有 %1 个开口。</translation>
    </message>
    <message>
        <source>Of the whole surface, at most</source>
        <translation>占整个表面至多</translation>
    </message>
    <message>
        <source>as far as its openings tell; behind them there may be more</source>
        <translation>根据开口估计；其后可能还有更多</translation>
    </message>
    <message>
        <source>Openings</source>
        <translation>开口</translation>
    </message>
    <message>
        <source>Loose pieces</source>
        <translation>零散部分</translation>
    </message>
    <message>
        <source>what joins them was not seen</source>
        <translation>连接它们的部分没有被看到</translation>
    </message>
    <message>
        <source>Closed, to be printed</source>
        <translation>封闭，可打印</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>是</translation>
    </message>
    <message>
        <source>no</source>
        <translation>否</translation>
    </message>
    <message>
        <source>What is open is where you erased what is not the object: turn the object over to see what was hidden there, or close the openings when the model is used.</source>
        <translation>开口位于您擦除非物体部分之处：请翻转物体以查看那里遮住的部分，或在使用模型时封闭开口。</translation>
    </message>
    <message>
        <source>%1 of them where you erased something</source>
        <translation>其中 %1 个位于您擦除之处</translation>
    </message>
</context>
<context>
    <name>CompositeScene</name>
    <message>
        <source>Object and stand</source>
        <translation>物体与摆放</translation>
    </message>
    <message>
        <source>object</source>
        <translation>物体</translation>
    </message>
    <message>
        <source>stand</source>
        <translation>摆放</translation>
    </message>
    <message>
        <source>on each other</source>
        <translation>相互重合</translation>
    </message>
    <message>
        <source>contradicted</source>
        <translation>相互矛盾</translation>
    </message>
    <message>
        <source>expected, not seen</source>
        <translation>应见而未见</translation>
    </message>
</context>
<context>
    <name>DeviceBench</name>
    <message>
        <source>Ready.</source>
        <translation>就绪。</translation>
    </message>
    <message>
        <source>At rest at %1°, as it reports.</source>
        <translation>静止于 %1°（转台报告）。</translation>
    </message>
    <message>
        <source>Told to stand at %1°; it does not report.</source>
        <translation>已命令停在 %1°；转台不报告角度。</translation>
    </message>
    <message>
        <source>Scanner</source>
        <translation>扫描仪</translation>
    </message>
    <message>
        <source>Turntable</source>
        <translation>转台</translation>
    </message>
    <message>
        <source>Ready; where it stands is known after its first move.</source>
        <translation>就绪；首次转动之后才知道其所在角度。</translation>
    </message>
</context>
<context>
    <name>DroppedFiles</name>
    <message>
        <source>%1 is a list of poses: it is chosen where scans are imported.</source>
        <translation>%1 是位姿列表：请在导入扫描时选择。</translation>
    </message>
    <message>
        <source>%1 is a profile or a file of settings: it is chosen on the first page.</source>
        <translation>%1 是配置文件或设置文件：请在第一页选择。</translation>
    </message>
    <message>
        <source>The folder %1 holds %2 sessions: drop the one that you mean.</source>
        <translation>文件夹 %1 中有 %2 个会话：请拖放所要的那一个。</translation>
    </message>
    <message>
        <source>The folder %1 holds no session and no scans.</source>
        <translation>文件夹 %1 中没有会话，也没有扫描。</translation>
    </message>
    <message>
        <source>%1 is a session</source>
        <translation>%1 是会话</translation>
    </message>
    <message>
        <source>%1 is a mesh</source>
        <translation>%1 是网格</translation>
    </message>
    <message>
        <source>%1 is a scan</source>
        <translation>%1 是扫描</translation>
    </message>
    <message>
        <source>Nothing that was dropped is a file of this computer.</source>
        <translation>拖放的内容都不是本机上的文件。</translation>
    </message>
    <message>
        <source>%1, %2: drop one kind at a time.</source>
        <translation>%1，%2：一次请只拖放一种。</translation>
    </message>
    <message>
        <source>%1 and %2 are sessions: one is opened at a time.</source>
        <translation>%1 和 %2 都是会话：一次只能打开一个。</translation>
    </message>
    <message>
        <source>%1 and %2 are meshes: one is taken at a time.</source>
        <translation>%1 和 %2 都是网格：一次只能采用一个。</translation>
    </message>
    <message>
        <source>A session or its folder, scans, or one mesh can be dropped here.</source>
        <translation>可将会话或其文件夹、扫描或一个网格拖放到此处。</translation>
    </message>
</context>
<context>
    <name>Ending</name>
    <message>
        <source> Position %1 would still show %2.</source>
        <translation>位置 %1 还可显示 %2。</translation>
    </message>
    <message>
        <source>If the table stood wrong, turn it to position %1 and take that once more.</source>
        <translation>如果转台当时角度有误，请将其转到位置 %1 并重新扫描一次。</translation>
    </message>
    <message>
        <source>If the table stood wrong, take position %1 once more; else go on from position %2.</source>
        <translation>如果转台当时角度有误，请从位置 %1 重新扫描一次；否则从位置 %2 继续。</translation>
    </message>
    <message>
        <source>Ended: the views that were asked for are taken.</source>
        <translation>已结束：所要求的视图已采集完毕。</translation>
    </message>
    <message>
        <source> from position %1</source>
        <translation>（位置 %1）</translation>
    </message>
    <message>
        <source>Scan %1%2 did not fit: %3.</source>
        <translation>扫描 %1%2未能吻合：%3。</translation>
    </message>
    <message>
        <source> It is kept, but not part of the model. </source>
        <translation>它被保留，但不属于模型。</translation>
    </message>
</context>
<context>
    <name>ImportDialog</name>
    <message>
        <source>millimetres</source>
        <translation>毫米</translation>
    </message>
    <message>
        <source>centimetres</source>
        <translation>厘米</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>英寸</translation>
    </message>
    <message>
        <source>metres</source>
        <translation>米</translation>
    </message>
    <message>
        <source>along z, y down (a camera)</source>
        <translation>沿 z，y 向下（相机）</translation>
    </message>
    <message>
        <source>along −z, y up (OpenGL)</source>
        <translation>沿 −z，y 向上（OpenGL）</translation>
    </message>
    <message>
        <source>along x</source>
        <translation>沿 x</translation>
    </message>
    <message>
        <source>along −x</source>
        <translation>沿 −x</translation>
    </message>
    <message>
        <source>along y</source>
        <translation>沿 y</translation>
    </message>
    <message>
        <source>along −y</source>
        <translation>沿 −y</translation>
    </message>
    <message>
        <source>points are in the object&apos;s coordinates</source>
        <translation>点采用物体坐标</translation>
    </message>
    <message>
        <source>columns go around an axis</source>
        <translation>各列绕一轴排列</translation>
    </message>
    <message>
        <source>points are in the coordinates of the profile</source>
        <translation>点采用配置文件的坐标</translation>
    </message>
</context>
<context>
    <name>JobPanel</name>
    <message>
        <source>scanning</source>
        <translation>扫描中</translation>
    </message>
    <message>
        <source>registering</source>
        <translation>配准中</translation>
    </message>
    <message>
        <source>preparing the views</source>
        <translation>准备视图</translation>
    </message>
    <message>
        <source>refining all views</source>
        <translation>精化所有视图</translation>
    </message>
    <message>
        <source>merging</source>
        <translation>合并中</translation>
    </message>
    <message>
        <source>finding what is unseen</source>
        <translation>查找未见部分</translation>
    </message>
    <message>
        <source>projecting what is unseen</source>
        <translation>投影未见部分</translation>
    </message>
    <message>
        <source>projecting what was seen</source>
        <translation>投影已见部分</translation>
    </message>
    <message>
        <source>choosing the next view</source>
        <translation>选择下一视图</translation>
    </message>
    <message>
        <source>joining surfaces</source>
        <translation>连接表面</translation>
    </message>
    <message>
        <source>moving the surface to where the views agree</source>
        <translation>使表面与各视图一致</translation>
    </message>
    <message>
        <source>preparing</source>
        <translation>准备中</translation>
    </message>
    <message>
        <source>searching</source>
        <translation>查找中</translation>
    </message>
    <message>
        <source>checking</source>
        <translation>检验中</translation>
    </message>
    <message>
        <source>finding the axis</source>
        <translation>求轴</translation>
    </message>
    <message>
        <source>closing openings</source>
        <translation>封闭开口</translation>
    </message>
    <message>
        <source>taking fewer triangles</source>
        <translation>减少三角形</translation>
    </message>
    <message>
        <source>reading the profile</source>
        <translation>读取配置文件</translation>
    </message>
    <message>
        <source>reading the object</source>
        <translation>读取物体</translation>
    </message>
    <message>
        <source>reading the session</source>
        <translation>读取会话</translation>
    </message>
    <message>
        <source>reading the scan</source>
        <translation>读取扫描</translation>
    </message>
    <message>
        <source>reading the scans</source>
        <translation>读取扫描</translation>
    </message>
    <message>
        <source>reading a recorded scan</source>
        <translation>读取录制的扫描</translation>
    </message>
    <message>
        <source>positional space of the scanner</source>
        <translation>扫描仪的位置空间</translation>
    </message>
    <message>
        <source>reading %1</source>
        <translation>读取 %1</translation>
    </message>
</context>
<context>
    <name>ModelView</name>
    <message>
        <source>edge against the background</source>
        <translation>背景前的边</translation>
    </message>
    <message>
        <source>hidden behind the object</source>
        <translation>被物体遮挡</translation>
    </message>
    <message>
        <source>light or camera blocked</source>
        <translation>光线或相机被遮挡</translation>
    </message>
    <message>
        <source>open border</source>
        <translation>开放边界</translation>
    </message>
    <message>
        <source>rim of the scan</source>
        <translation>扫描边缘</translation>
    </message>
    <message>
        <source>open</source>
        <translation>未解决</translation>
    </message>
    <message>
        <source>looked at, still open</source>
        <translation>已看过，仍未解决</translation>
    </message>
    <message>
        <source>answered: no surface found</source>
        <translation>已解决：未发现表面</translation>
    </message>
    <message>
        <source>out of reach</source>
        <translation>不可及</translation>
    </message>
    <message>
        <source>too steep</source>
        <translation>过陡</translation>
    </message>
    <message>
        <source>light blocked</source>
        <translation>光线被遮挡</translation>
    </message>
    <message>
        <source>receiver blocked</source>
        <translation>接收器被遮挡</translation>
    </message>
    <message>
        <source>too little for a view</source>
        <translation>不足以构成一个视图</translation>
    </message>
    <message>
        <source>Unseen edges by kind</source>
        <translation>未见边（按类型）</translation>
    </message>
    <message>
        <source>Unseen edges by state</source>
        <translation>未见边（按状态）</translation>
    </message>
    <message>
        <source>Surface by view</source>
        <translation>表面（按视图）</translation>
    </message>
    <message>
        <source>view %1, position %2</source>
        <translation>视图 %1，位置 %2</translation>
    </message>
    <message>
        <source>view %1</source>
        <translation>视图 %1</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>另有 %1 个</translation>
    </message>
    <message>
        <source>Surface by stand</source>
        <translation>表面（按摆放）</translation>
    </message>
    <message>
        <source>stand %1, 1 view</source>
        <translation>摆放 %1，1 个视图</translation>
    </message>
    <message>
        <source>stand %1, %2 views</source>
        <translation>摆放 %1，%2 个视图</translation>
    </message>
    <message>
        <source>Surface in its colours</source>
        <translation>表面真实颜色</translation>
    </message>
    <message>
        <source>no colour was measured</source>
        <translation>未测得颜色</translation>
    </message>
    <message>
        <source>1 unseen edge</source>
        <translation>1 条未见边</translation>
    </message>
    <message>
        <source>%1 unseen edges</source>
        <translation>%1 条未见边</translation>
    </message>
    <message>
        <source>Stand %1 alone after 1 view</source>
        <translation>仅摆放 %1，1 个视图之后</translation>
    </message>
    <message>
        <source>Stand %1 alone after %2 views</source>
        <translation>仅摆放 %1，%2 个视图之后</translation>
    </message>
    <message>
        <source>Model after 1 view</source>
        <translation>1 个视图之后的模型</translation>
    </message>
    <message>
        <source>Model after %1 views</source>
        <translation>%1 个视图之后的模型</translation>
    </message>
    <message>
        <source>Before the first scan</source>
        <translation>首次扫描之前</translation>
    </message>
    <message>
        <source>The scanner at position %1</source>
        <translation>扫描仪在位置 %1</translation>
    </message>
    <message>
        <source>The simulated object and the viewing volume</source>
        <translation>模拟物体与测量空间</translation>
    </message>
    <message>
        <source>The viewing volume</source>
        <translation>测量空间</translation>
    </message>
    <message>
        <source>No view taken yet</source>
        <translation>尚未采集视图</translation>
    </message>
    <message>
        <source>No view of stand %1 taken yet</source>
        <translation>摆放 %1 尚未采集视图</translation>
    </message>
    <message>
        <source>The object is set aside meanwhile</source>
        <translation>物体暂时搁置</translation>
    </message>
    <message>
        <source>Not put together with the object yet</source>
        <translation>尚未与物体合为一体</translation>
    </message>
    <message>
        <source>%1 triangles</source>
        <translation>%1 个三角形</translation>
    </message>
    <message>
        <source>%1, %2 mm²</source>
        <translation>%1，%2 mm²</translation>
    </message>
    <message>
        <source>Confidence</source>
        <translation>置信度</translation>
    </message>
    <message>
        <source>(1: seen head-on)</source>
        <translation>（1：正面看到）</translation>
    </message>
    <message>
        <source>Surface by age</source>
        <translation>表面（按先后）</translation>
    </message>
    <message>
        <source>view</source>
        <translation>视图</translation>
    </message>
    <message>
        <source>Ranging rays</source>
        <translation>测距射线</translation>
    </message>
    <message>
        <source>last view, position %1</source>
        <translation>上一视图，位置 %1</translation>
    </message>
    <message>
        <source>examined position %1</source>
        <translation>查看的位置 %1</translation>
    </message>
    <message>
        <source>your choice, position %1</source>
        <translation>您的选择，位置 %1</translation>
    </message>
    <message>
        <source>proposed view, position %1</source>
        <translation>建议的视图，位置 %1</translation>
    </message>
    <message>
        <source>Marks</source>
        <translation>标记</translation>
    </message>
    <message>
        <source>border of the model</source>
        <translation>模型边界</translation>
    </message>
    <message>
        <source>what the chosen scan brought</source>
        <translation>所选扫描带来的部分</translation>
    </message>
    <message>
        <source>where the scanner stands, position %1</source>
        <translation>扫描仪所在处，位置 %1</translation>
    </message>
    <message>
        <source>where it is next, position %1</source>
        <translation>扫描仪下一处，位置 %1</translation>
    </message>
    <message>
        <source>erased: not the object</source>
        <translation>已擦除：非物体</translation>
    </message>
    <message>
        <source>what would be erased</source>
        <translation>将被擦除的部分</translation>
    </message>
</context>
<context>
    <name>Moments</name>
    <message>
        <source>Session begun</source>
        <translation>会话开始</translation>
    </message>
</context>
<context>
    <name>Notices</name>
    <message>
        <source>In the folder %1.</source>
        <translation>在文件夹 %1 中。</translation>
    </message>
    <message>
        <source>Vantage</source>
        <translation>Vantage</translation>
    </message>
    <message>
        <source>More happened meanwhile, see the details.</source>
        <translation>期间还发生了其他事情，请看详细信息。</translation>
    </message>
</context>
<context>
    <name>ObjectFigures</name>
    <message>
        <source>The object without it</source>
        <translation>不含它的物体</translation>
    </message>
    <message>
        <source>%1 views; that is what is exported</source>
        <translation>%1 个视图；导出的就是它</translation>
    </message>
</context>
<context>
    <name>ObjectiveView</name>
    <message>
        <source>%1, %2° up</source>
        <translation>%1，向上 %2°</translation>
    </message>
    <message>
        <source>Next view, your choice: position %1</source>
        <translation>下一视图（您的选择）：位置 %1</translation>
    </message>
    <message>
        <source>Next best view: position %1</source>
        <translation>下一最佳视图：位置 %1</translation>
    </message>
    <message>
        <source>Ended; position %1 would be next</source>
        <translation>已结束；下一个会是位置 %1</translation>
    </message>
    <message>
        <source>No next view</source>
        <translation>没有下一视图</translation>
    </message>
    <message>
        <source>, taken</source>
        <translation>，已采集</translation>
    </message>
    <message>
        <source>, ruled out</source>
        <translation>，已排除</translation>
    </message>
    <message>
        <source>void mm²</source>
        <translation>未知 mm²</translation>
    </message>
    <message>
        <source>overlap mm²</source>
        <translation>重叠 mm²</translation>
    </message>
    <message>
        <source>Nothing is planned from recorded scans</source>
        <translation>已录制的扫描不做规划</translation>
    </message>
    <message>
        <source>No plan yet</source>
        <translation>尚无规划</translation>
    </message>
    <message>
        <source>F = %1</source>
        <translation>F = %1</translation>
    </message>
    <message>
        <source>o_s: overlap</source>
        <translation>o_s：重叠</translation>
    </message>
    <message>
        <source>t = %1</source>
        <translation>t = %1</translation>
    </message>
    <message>
        <source>now</source>
        <translation>当前</translation>
    </message>
    <message>
        <source>next</source>
        <translation>下一个</translation>
    </message>
    <message>
        <source>asked</source>
        <translation>查询</translation>
    </message>
    <message>
        <source>ruled out</source>
        <translation>已排除</translation>
    </message>
    <message>
        <source>position %1, at %2</source>
        <translation>位置 %1，%2</translation>
    </message>
    <message>
        <source>would show %1, overlap %2</source>
        <translation>将显示 %1，重叠 %2</translation>
    </message>
    <message>
        <source>o_v: would show</source>
        <translation>o_v：将显示</translation>
    </message>
</context>
<context>
    <name>Outlook</name>
    <message>
        <source>about %1 s</source>
        <translation>约 %1 秒</translation>
    </message>
    <message>
        <source>about %1 min</source>
        <translation>约 %1 分钟</translation>
    </message>
    <message>
        <source>about %1 h</source>
        <translation>约 %1 小时</translation>
    </message>
    <message>
        <source>about 1 more view</source>
        <translation>约还需 1 个视图</translation>
    </message>
    <message>
        <source>about %1 more views</source>
        <translation>约还需 %1 个视图</translation>
    </message>
    <message>
        <source>%1, %2 by an estimate</source>
        <translation>%1，估计 %2</translation>
    </message>
</context>
<context>
    <name>Permissions</name>
    <message>
        <source>Something else is under way.</source>
        <translation>其他操作正在进行。</translation>
    </message>
    <message>
        <source>This session is open to be looked at only.</source>
        <translation>此会话仅供查看。</translation>
    </message>
    <message>
        <source>Scanner and object are not read yet.</source>
        <translation>扫描仪和物体尚未读取。</translation>
    </message>
    <message>
        <source>The simulated scanner has nothing to look at: %1</source>
        <translation>模拟扫描仪没有可看的物体：%1</translation>
    </message>
    <message>
        <source>The scans of this session were recorded elsewhere: no scanner belongs to it.</source>
        <translation>此会话的扫描是在别处录制的：没有对应的扫描仪。</translation>
    </message>
    <message>
        <source>The simulated scanner needs an object: choose one.</source>
        <translation>模拟扫描仪需要一个物体：请选择。</translation>
    </message>
    <message>
        <source>You turn the table yourself: scan one view at a time, or choose automatic.</source>
        <translation>由您自己转动转台：请逐个视图扫描，或选择“自动”。</translation>
    </message>
    <message>
        <source>The table is turned by hand: choose assisted.</source>
        <translation>转台由手转动：请选择“协助”。</translation>
    </message>
    <message>
        <source>The session has begun. Tests with its devices are made before the first scan.</source>
        <translation>会话已开始。设备测试须在首次扫描之前进行。</translation>
    </message>
    <message>
        <source>This scanner has no turntable.</source>
        <translation>此扫描仪没有转台。</translation>
    </message>
    <message>
        <source>There is no session yet: it begins with the first scan.</source>
        <translation>还没有会话：首次扫描时开始。</translation>
    </message>
    <message>
        <source>The object has stood in one stand only.</source>
        <translation>物体只有过一种摆放。</translation>
    </message>
    <message>
        <source>All stands that have views are in place.</source>
        <translation>所有含视图的摆放均已就位。</translation>
    </message>
    <message>
        <source>No session is open.</source>
        <translation>没有打开的会话。</translation>
    </message>
</context>
<context>
    <name>Phrase</name>
    <message>
        <source>%1: is damaged; before anything was written to it, it was copied to %2</source>
        <translation>%1：已损坏；写入之前已复制到 %2</translation>
    </message>
    <message>
        <source>%1: the table %2 is damaged, %3 rows of it were read</source>
        <translation>%1：表 %2 已损坏，读取了其中 %3 行</translation>
    </message>
    <message>
        <source>%1: not all rows of %2 could be read</source>
        <translation>%1：%2 的行未能全部读取</translation>
    </message>
    <message>
        <source>%1: step %2, the last one, is lost</source>
        <translation>%1：最后一步（步骤 %2）已丢失</translation>
    </message>
    <message>
        <source>%1: step %2 is lost</source>
        <translation>%1：步骤 %2 已丢失</translation>
    </message>
    <message>
        <source>%1: step %2 is lost: not all of its views are there</source>
        <translation>%1：步骤 %2 已丢失：其视图不全</translation>
    </message>
    <message>
        <source>%1: step %2 is lost: it names no position</source>
        <translation>%1：步骤 %2 已丢失：没有给出位置</translation>
    </message>
    <message>
        <source>%1; it is made again</source>
        <translation>%1；将重新生成</translation>
    </message>
    <message>
        <source>%1: model %2 is of other views; it is made again</source>
        <translation>%1：模型 %2 属于其他视图；将重新生成</translation>
    </message>
    <message>
        <source>%1: model %2 is of other samples; it is made again</source>
        <translation>%1：模型 %2 属于其他采样点；将重新生成</translation>
    </message>
    <message>
        <source>%1: plan %2 is of other positions</source>
        <translation>%1：规划 %2 属于其他位置</translation>
    </message>
    <message>
        <source>%1: step %2 was not as it was written; it was carried out again from its scans</source>
        <translation>%1：步骤 %2 与写入时不符；已根据其扫描重新执行</translation>
    </message>
    <message>
        <source>%1: step %2 is not as it was written: do not trust its model. Go back to a step before it, or begin anew with its scans</source>
        <translation>%1：步骤 %2 与写入时不符：请勿信任其模型。请退回到之前的步骤，或用其扫描重新开始</translation>
    </message>
    <message>
        <source>%1: %2 files of the scanner&apos;s profile are lost</source>
        <translation>%1：扫描仪配置的 %2 个文件已丢失</translation>
    </message>
    <message>
        <source>%1: the object of the simulated scanner is not the one that was kept</source>
        <translation>%1：模拟扫描仪的物体不是所保存的那个</translation>
    </message>
    <message>
        <source>%1: %2 more damages of this kind</source>
        <translation>%1：另有 %2 处此类损坏</translation>
    </message>
    <message>
        <source>%1: %2 more of %3 are damaged</source>
        <translation>%1：%3 中另有 %2 处已损坏</translation>
    </message>
    <message>
        <source>%1: has very many steps; those before step %2 were not read, and stay in the file</source>
        <translation>%1：步骤很多；步骤 %2 之前的未读取，仍保留在文件中</translation>
    </message>
    <message>
        <source>%1 MB</source>
        <translation>%1 MB</translation>
    </message>
    <message>
        <source>%1 GB</source>
        <translation>%1 GB</translation>
    </message>
    <message>
        <source>the scanner has %1 million rays: this takes about %2 of memory, about %3 more with every scan, and every step some time</source>
        <translation>扫描仪有 %1 百万条射线：约需 %2 内存，每次扫描再增加约 %3，每一步都要花些时间</translation>
    </message>
    <message>
        <source>%1; of every scan about %2 million samples are worked on, the session keeps all</source>
        <translation>%1；每次扫描处理约 %2 百万个采样点，会话保留全部</translation>
    </message>
    <message>
        <source>assumed</source>
        <translation>假定</translation>
    </message>
    <message>
        <source>told by the numbers</source>
        <translation>由数值得出</translation>
    </message>
    <message>
        <source>as the file says</source>
        <translation>按文件</translation>
    </message>
    <message>
        <source>as given</source>
        <translation>按给定</translation>
    </message>
    <message>
        <source>(%1, %2, %3)</source>
        <translation>（%1，%2，%3）</translation>
    </message>
    <message>
        <source>the scanner looks along %1 (%2)</source>
        <translation>扫描仪朝 %1 方向（%2）</translation>
    </message>
    <message>
        <source>measured from one point in all directions (%1)</source>
        <translation>从一点向各方向测量（%1）</translation>
    </message>
    <message>
        <source>the columns go around an axis, like a cylinder (%1)</source>
        <translation>各列如圆柱般绕轴排列（%1）</translation>
    </message>
    <message>
        <source>the rays are those of the profile</source>
        <translation>射线采用配置文件中的射线</translation>
    </message>
    <message>
        <source>%1 cells with the value given for no sample left out</source>
        <translation>略去 %1 个具有“无采样”值的单元</translation>
    </message>
    <message>
        <source>%1 cells with the point (0, 0, 0) left out as no samples</source>
        <translation>%1 个点为 (0, 0, 0) 的单元视为无采样，已略去</translation>
    </message>
    <message>
        <source>%1 cells with one and the same point left out as no samples</source>
        <translation>%1 个点完全相同的单元视为无采样，已略去</translation>
    </message>
    <message>
        <source>%1 cells at one constant depth left out as no samples</source>
        <translation>%1 个深度恒定的单元视为无采样，已略去</translation>
    </message>
    <message>
        <source>%1 cells out of all proportion left out</source>
        <translation>略去 %1 个明显离谱的单元</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>the points are in the object&apos;s coordinates already, no pose is applied</source>
        <translation>点已是物体坐标，不应用位姿</translation>
    </message>
    <message>
        <source>the poses have another unit: 1 = %1 mm (%2)</source>
        <translation>位姿采用另一单位：1 = %1 mm（%2）</translation>
    </message>
    <message>
        <source>%1 is up</source>
        <translation>%1 朝上</translation>
    </message>
    <message>
        <source>z is taken for up although the poses turn about %1</source>
        <translation>以 z 为上，尽管位姿绕 %1 转动</translation>
    </message>
    <message>
        <source>1 unit = %1 mm (%2)</source>
        <translation>1 单位 = %1 mm（%2）</translation>
    </message>
    <message>
        <source>rows and columns are exchanged</source>
        <translation>行与列互换</translation>
    </message>
    <message>
        <source>an offset of (%1, %2, %3) mm was taken off</source>
        <translation>已减去偏移 (%1, %2, %3) mm</translation>
    </message>
    <message>
        <source>scan %1 was rejected and is not in the model: %2</source>
        <translation>扫描 %1 被拒绝，不在模型中：%2</translation>
    </message>
    <message>
        <source>scan %1, whose table was turned by hand, is doubtful and may be off by %2 mm: %3</source>
        <translation>扫描 %1（转台由手转动）存疑，可能偏差 %2 mm：%3</translation>
    </message>
    <message>
        <source>scan %1 is doubtful: %2</source>
        <translation>扫描 %1 存疑：%2</translation>
    </message>
    <message>
        <source>scan %1 waits until it is known how the object stood</source>
        <translation>扫描 %1 等待确定物体的摆放</translation>
    </message>
    <message>
        <source>the model has no surface: nothing of the object was covered</source>
        <translation>模型没有表面：物体未被覆盖</translation>
    </message>
    <message>
        <source>little is covered: there are positions that would still show %1 % of what the model has</source>
        <translation>覆盖很少：仍有位置可显示相当于现有模型 %1 % 的部分</translation>
    </message>
    <message>
        <source>scan %1 fits where the table would have turned the other way: if it always does, calibrate it, or say that its sense is -1</source>
        <translation>扫描 %1 与转台反向转动的位置吻合：如果总是如此，请标定转台，或将其转向设为 -1</translation>
    </message>
    <message>
        <source>stand %1 is not aligned with the others yet and is not in the model</source>
        <translation>摆放 %1 尚未与其他摆放对齐，不在模型中</translation>
    </message>
    <message>
        <source>stand %1 is not in the model: %2</source>
        <translation>摆放 %1 不在模型中：%2</translation>
    </message>
    <message>
        <source>stand %1 is in the model although something speaks against it: %2</source>
        <translation>摆放 %1 在模型中，尽管有不利证据：%2</translation>
    </message>
    <message>
        <source>the acquisition is not finished. %1</source>
        <translation>采集未完成。%1</translation>
    </message>
    <message>
        <source>it fits if the turns go the other way, %1 times as far as listed</source>
        <translation>如果反向转动，且幅度为列表的 %1 倍，则吻合</translation>
    </message>
    <message>
        <source>it fits if every turn is %1 times what the list says</source>
        <translation>如果每次转动为列表所述的 %1 倍，则吻合</translation>
    </message>
    <message>
        <source>%1 degrees</source>
        <translation>%1 度</translation>
    </message>
    <message>
        <source>%1, and as well at %2 degrees</source>
        <translation>%1，在 %2 度处同样吻合</translation>
    </message>
    <message>
        <source>Set-up changed</source>
        <translation>设置已更改</translation>
    </message>
    <message>
        <source>Scan %1 added</source>
        <translation>已添加扫描 %1</translation>
    </message>
    <message>
        <source>%1 recorded scans imported</source>
        <translation>已导入 %1 个录制的扫描</translation>
    </message>
    <message>
        <source>Position %1 chosen</source>
        <translation>已选择位置 %1</translation>
    </message>
    <message>
        <source>Proposed position taken again</source>
        <translation>已恢复建议的位置</translation>
    </message>
    <message>
        <source>Scan %1 left out</source>
        <translation>已略去扫描 %1</translation>
    </message>
    <message>
        <source>Scan %1 taken back</source>
        <translation>已恢复扫描 %1</translation>
    </message>
    <message>
        <source>Scan %1 taken as from %2 degrees</source>
        <translation>扫描 %1 按 %2 度采用</translation>
    </message>
    <message>
        <source>Opened again</source>
        <translation>重新打开</translation>
    </message>
    <message>
        <source>Ended: %1</source>
        <translation>已结束：%1</translation>
    </message>
    <message>
        <source>Taken over from an earlier version</source>
        <translation>取自旧版本</translation>
    </message>
    <message>
        <source>Object turned over</source>
        <translation>物体已翻转</translation>
    </message>
    <message>
        <source>Stand %1 placed</source>
        <translation>摆放 %1 已就位</translation>
    </message>
    <message>
        <source>Alignment of stand %1</source>
        <translation>摆放 %1 的对齐</translation>
    </message>
    <message>
        <source>Pose %1 chosen for stand %2</source>
        <translation>为摆放 %2 选择了位姿 %1</translation>
    </message>
    <message>
        <source>Object known by stand %1</source>
        <translation>物体由摆放 %1 确定</translation>
    </message>
    <message>
        <source>Automatic from here</source>
        <translation>自此自动</translation>
    </message>
    <message>
        <source>Assisted from here</source>
        <translation>自此协助</translation>
    </message>
    <message>
        <source>slides along %1</source>
        <translation>沿 %1 滑动</translation>
    </message>
    <message>
        <source>turns about %1</source>
        <translation>绕 %1 转动</translation>
    </message>
    <message>
        <source>moves freely</source>
        <translation>自由移动</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 和 %2</translation>
    </message>
    <message>
        <source>not registered</source>
        <translation>未配准</translation>
    </message>
    <message>
        <source>the first view defines the frame</source>
        <translation>第一个视图确定坐标系</translation>
    </message>
    <message>
        <source>the first view is where the others go</source>
        <translation>第一个视图是其他视图的基准</translation>
    </message>
    <message>
        <source>registered by an earlier version</source>
        <translation>由旧版本配准</translation>
    </message>
    <message>
        <source>%1 % of the expected overlap fits</source>
        <translation>预期重叠的 %1 % 吻合</translation>
    </message>
    <message>
        <source>only %1 % of the expected overlap fits</source>
        <translation>预期重叠只有 %1 % 吻合</translation>
    </message>
    <message>
        <source>only %1 points overlap with the model</source>
        <translation>只有 %1 个点与模型重叠</translation>
    </message>
    <message>
        <source>the scanner looked through %1 % of the model&apos;s surface</source>
        <translation>扫描仪看穿了模型表面的 %1 %</translation>
    </message>
    <message>
        <source>the surfaces differ %1 times as much as their noise explains</source>
        <translation>表面差异是噪声所能解释的 %1 倍</translation>
    </message>
    <message>
        <source>it moved %1 sigma away from where the mechanics put it</source>
        <translation>它偏离机械给出的位置 %1 σ</translation>
    </message>
    <message>
        <source>a pose %1 mm away fits as well</source>
        <translation>相距 %1 mm 的位姿同样吻合</translation>
    </message>
    <message>
        <source>the surface %1: that part of the pose is the mechanics&apos; word alone</source>
        <translation>表面%1：位姿的这一部分仅由机械确定</translation>
    </message>
    <message>
        <source>the pose had not come to rest when the iterations ran out</source>
        <translation>迭代用尽时位姿仍未稳定</translation>
    </message>
    <message>
        <source>it contradicts what the other scans agree on, with %1 % of its points there</source>
        <translation>它与其他扫描一致之处相矛盾，涉及其在该处 %1 % 的点</translation>
    </message>
    <message>
        <source>no pose was given for it, and its surface alone does not say where it belongs</source>
        <translation>没有给出它的位姿，仅凭其表面无法确定它的归属</translation>
    </message>
    <message>
        <source>it does not fit the position that it was said to be of; it fits position %1</source>
        <translation>它与所称的位置不吻合；与位置 %1 吻合</translation>
    </message>
    <message>
        <source>it fits %1 degrees away from where the table says it is: did the table slip, or was it pushed?</source>
        <translation>它与转台所报角度相差 %1 度处吻合：转台是否打滑或被碰到？</translation>
    </message>
    <message>
        <source>it does not fit where it was said to be taken; it fits where the table stands at %1</source>
        <translation>它与所称的采集处不吻合；转台位于 %1 时吻合</translation>
    </message>
    <message>
        <source>it was taken as from %1 degrees of the table, where it fits</source>
        <translation>按转台 %1 度采用，在该处吻合</translation>
    </message>
    <message>
        <source>it fits if the list has the inverse of every pose</source>
        <translation>如果列表给出的是各位姿的逆，则吻合</translation>
    </message>
    <message>
        <source>it fits if positions in the list are taken times %1: another unit</source>
        <translation>如果列表中的位置乘以 %1，则吻合：单位不同</translation>
    </message>
    <message>
        <source>it fits if the scanner&apos;s other axes than %1 point the other way</source>
        <translation>如果扫描仪除 %1 以外的轴反向，则吻合</translation>
    </message>
    <message>
        <source>it fits if the axis is %1 mm beside where the list has it</source>
        <translation>如果轴与列表所述相差 %1 mm，则吻合</translation>
    </message>
    <message>
        <source>only %1 points overlap with the model: the table alone says where it belongs</source>
        <translation>只有 %1 个点与模型重叠：仅由转台确定其归属</translation>
    </message>
    <message>
        <source>all scans together hold it</source>
        <translation>由所有扫描共同固定</translation>
    </message>
    <message>
        <source>one pose is possible, with %1 % of the surface in common</source>
        <translation>有一个可能的位姿，共有表面 %1 %</translation>
    </message>
    <message>
        <source>the surfaces slide along each other</source>
        <translation>表面可相互滑动</translation>
    </message>
    <message>
        <source>%1 poses are possible, and all leave the same surface</source>
        <translation>有 %1 个可能的位姿，得到的表面都相同</translation>
    </message>
    <message>
        <source>%1 poses are possible</source>
        <translation>有 %1 个可能的位姿</translation>
    </message>
    <message>
        <source>%1 % of the surface cannot be there in the best pose, or should have been seen and was not</source>
        <translation>在最佳位姿下，%1 % 的表面不可能在该处，或应看到而未看到</translation>
    </message>
    <message>
        <source>only %1 % of the surface is in common</source>
        <translation>共有表面只有 %1 %</translation>
    </message>
    <message>
        <source>it does not fit in one piece: views moved %1 sigma away from where the mechanics put them</source>
        <translation>整体不吻合：有视图偏离机械给出的位置 %1 σ</translation>
    </message>
    <message>
        <source>no pose fits</source>
        <translation>没有吻合的位姿</translation>
    </message>
    <message>
        <source>Erased below a plane</source>
        <translation>已擦除平面以下的部分</translation>
    </message>
    <message>
        <source>Erased in a box</source>
        <translation>已擦除矩形内的部分</translation>
    </message>
    <message>
        <source>Erased in a lasso</source>
        <translation>已擦除套索内的部分</translation>
    </message>
    <message>
        <source>Erased pieces</source>
        <translation>已擦除零散部分</translation>
    </message>
    <message>
        <source>Erasure %1 taken back</source>
        <translation>已恢复擦除 %1</translation>
    </message>
    <message>
        <source>it fits only scans whose own place is doubtful</source>
        <translation>仅与自身位置存疑的扫描吻合</translation>
    </message>
    <message>
        <source>too little holds it to the scans that hold each other</source>
        <translation>它与相互固定的扫描之间约束太少</translation>
    </message>
    <message>
        <source>the table alone says where it belongs, and the scan before it fits another turn of the table</source>
        <translation>仅由转台确定其归属，而前一扫描与转台的其他角度吻合</translation>
    </message>
</context>
<context>
    <name>PositionalSpace</name>
    <message>
        <source>per cell</source>
        <translation>每单元</translation>
    </message>
    <message>
        <source>P_v: void</source>
        <translation>P_v：未知</translation>
    </message>
    <message>
        <source>P_s: surface already seen</source>
        <translation>P_s：已见表面</translation>
    </message>
    <message>
        <source>P_c: rays of position %1</source>
        <translation>P_c：位置 %1 的射线</translation>
    </message>
    <message>
        <source>P_c: rays of all positions</source>
        <translation>P_c：所有位置的射线</translation>
    </message>
    <message>
        <source>positions</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>a window at %1 around, %2 mm up: %3 %4</source>
        <translation>窗口：周向 %1，高 %2 mm：%3 %4</translation>
    </message>
    <message>
        <source>no ranging ray leaves through it</source>
        <translation>没有测距射线由此射出</translation>
    </message>
    <message>
        <source>the scanner looks through it from %1 to %2 aside</source>
        <translation>扫描仪由此观察，侧向 %1 至 %2</translation>
    </message>
    <message>
        <source>, %1 to %2 up</source>
        <translation>，向上 %1 至 %2</translation>
    </message>
    <message>
        <source>No plan yet to show in positional space</source>
        <translation>位置空间中尚无可显示的规划</translation>
    </message>
    <message>
        <source>No positional space yet</source>
        <translation>尚无位置空间</translation>
    </message>
    <message>
        <source>in directions %1° aside, %2° up, each ± %3°</source>
        <translation>方向：侧向 %1°，向上 %2°，各 ± %3°</translation>
    </message>
    <message>
        <source>summed over all directions</source>
        <translation>对所有方向求和</translation>
    </message>
    <message>
        <source>Per cell</source>
        <translation>每单元</translation>
    </message>
</context>
<context>
    <name>Preferences</name>
    <message>
        <source>Theme</source>
        <translation>主题</translation>
    </message>
    <message>
        <source>Colours of the window and of the views.</source>
        <translation>窗口和视图的颜色。</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>浅色</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>深色</translation>
    </message>
    <message>
        <source>As the desktop</source>
        <translation>跟随桌面</translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation>鼠标</translation>
    </message>
    <message>
        <source>Which program the mouse buttons in the views follow.</source>
        <translation>视图中的鼠标操作遵循哪个程序。</translation>
    </message>
    <message>
        <source>Upright: the table stays level</source>
        <translation>直立：转台保持水平</translation>
    </message>
    <message>
        <source>Threads</source>
        <translation>线程</translation>
    </message>
    <message>
        <source>Processors that computing may use from the next start on; 0 takes all. Results never depend on it.</source>
        <translation>下次启动起计算可用的处理器数；0 表示全部。结果与此无关。</translation>
    </message>
    <message>
        <source>Go on where I was</source>
        <translation>从上次的地方继续</translation>
    </message>
    <message>
        <source>Open the session of last time at start if it was not ended.</source>
        <translation>启动时打开上次未结束的会话。</translation>
    </message>
    <message>
        <source>Sound</source>
        <translation>声音</translation>
    </message>
    <message>
        <source>Sound when scanning has ended or waits for you.</source>
        <translation>扫描结束或等待您时发出声音。</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>语言</translation>
    </message>
    <message>
        <source>Of the window, from the next start on. The command line and what is written in files stay English.</source>
        <translation>窗口的语言，下次启动起生效。命令行以及写入文件的内容仍为英文。</translation>
    </message>
</context>
<context>
    <name>PrintText</name>
    <message>
        <source>Nothing of it is left.</source>
        <translation>什么都没有剩下。</translation>
    </message>
    <message numerus="yes">
        <source>It has %n opening(s), the widest %1 mm wide: close them all.</source>
        <translation>
            <numerusform>有 %n 个开口，最宽 %1 mm：请全部封闭。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n edge(s) have more than two triangles, or two that face opposite ways.</source>
        <translation>
            <numerusform>%n 条边有两个以上的三角形，或两个朝向相反的三角形。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Surfaces only touch in %n place(s).</source>
        <translation>
            <numerusform>表面有 %n 处仅仅接触。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n piece(s) lie inside out.</source>
        <translation>
            <numerusform>%n 个部分内外颠倒。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pair(s) of triangles pass through each other.</source>
        <translation>
            <numerusform>%n 对三角形相互穿透。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>It is in %n piece(s): leave the loose ones out.</source>
        <translation>
            <numerusform>它由 %n 个部分组成：请略去零散部分。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n loose piece(s) left out, %1 mm².</source>
        <translation>
            <numerusform>略去 %n 个零散部分，%1 mm²。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n opening(s) closed: %1 mm² are invented, %2 mm² were measured.</source>
        <translation>
            <numerusform>封闭了 %n 个开口：%1 mm² 为虚构，%2 mm² 为实测。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n opening(s) stayed open.</source>
        <translation>
            <numerusform>%n 个开口仍未封闭。</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 triangles, no farther than %2 mm from the model.</source>
        <translation>%1 个三角形，与模型相距不超过 %2 mm。</translation>
    </message>
    <message>
        <source>Closed, %1 cm³.</source>
        <translation>封闭，%1 cm³。</translation>
    </message>
    <message>
        <source>Not closed: it encloses no volume.</source>
        <translation>未封闭：不包围任何体积。</translation>
    </message>
</context>
<context>
    <name>Refusal</name>
    <message>
        <source>These are recorded scans without a scanner: there are no positions to scan from.</source>
        <translation>这些是没有扫描仪的录制扫描：没有可供扫描的位置。</translation>
    </message>
    <message>
        <source>The scanner has no position %1.</source>
        <translation>扫描仪没有位置 %1。</translation>
    </message>
    <message>
        <source>The object has not stood in stand %1.</source>
        <translation>物体没有过摆放 %1。</translation>
    </message>
    <message>
        <source>How the object stands in stand %1 is known already.</source>
        <translation>物体在摆放 %1 中的姿态已知。</translation>
    </message>
    <message>
        <source>Scan %1 is not part of the model.</source>
        <translation>扫描 %1 不属于模型。</translation>
    </message>
    <message>
        <source>Scan %1 is the only view of the model.</source>
        <translation>扫描 %1 是模型的唯一视图。</translation>
    </message>
    <message>
        <source>Scan %1 was not left out.</source>
        <translation>扫描 %1 没有被略去。</translation>
    </message>
    <message>
        <source>Scan %1 was added before.</source>
        <translation>扫描 %1 此前已添加。</translation>
    </message>
    <message>
        <source>Recorded scans are imported into an empty session only.</source>
        <translation>录制的扫描只能导入空会话。</translation>
    </message>
    <message>
        <source>There is nothing to import.</source>
        <translation>没有可导入的内容。</translation>
    </message>
    <message>
        <source>The acquisition has ended.</source>
        <translation>采集已结束。</translation>
    </message>
    <message>
        <source>The acquisition has not ended.</source>
        <translation>采集尚未结束。</translation>
    </message>
    <message>
        <source>Nothing is proposed any more. Choose a position yourself to go on.</source>
        <translation>不再有建议。请自行选择位置以继续。</translation>
    </message>
    <message>
        <source>The greatest number of views, %1, is taken. Allow more to go on.</source>
        <translation>已采集最大视图数 %1。请允许更多以继续。</translation>
    </message>
    <message>
        <source>Nothing has been scanned yet.</source>
        <translation>尚未扫描任何内容。</translation>
    </message>
    <message>
        <source>The object and how scans become surfaces can only be changed before the first scan.</source>
        <translation>物体以及扫描生成表面的方式只能在首次扫描之前更改。</translation>
    </message>
    <message>
        <source>The settings contradict each other.</source>
        <translation>设置相互矛盾。</translation>
    </message>
    <message>
        <source>What an earlier version did cannot be done again.</source>
        <translation>旧版本所做的操作无法重做。</translation>
    </message>
    <message>
        <source>There is nothing to undo.</source>
        <translation>没有可撤销的操作。</translation>
    </message>
    <message>
        <source>There is nothing to redo.</source>
        <translation>没有可重做的操作。</translation>
    </message>
    <message>
        <source>There is nothing to scan with: no scanner, or no object for the simulated one.</source>
        <translation>无法扫描：没有扫描仪，或模拟扫描仪没有物体。</translation>
    </message>
    <message>
        <source>Scan %1 was not found to fit another turn of the table.</source>
        <translation>没有发现扫描 %1 与转台的其他角度吻合。</translation>
    </message>
    <message>
        <source>Stand %1 has no view yet: there is nothing to align.</source>
        <translation>摆放 %1 还没有视图：无可对齐。</translation>
    </message>
    <message>
        <source>Stand %1 has not been aligned yet.</source>
        <translation>摆放 %1 尚未对齐。</translation>
    </message>
    <message>
        <source>Pose %1 is none of those that were found.</source>
        <translation>位姿 %1 不在已找到的位姿之中。</translation>
    </message>
    <message>
        <source>Something speaks against pose %1.</source>
        <translation>位姿 %1 存在不利证据。</translation>
    </message>
    <message>
        <source>Several stands make the object already. Undo what put them together first.</source>
        <translation>物体已由多个摆放组成。请先撤销将它们合并的操作。</translation>
    </message>
    <message>
        <source>Scan %1 is of a stand that is not the one that is worked on.</source>
        <translation>扫描 %1 属于当前未处理的摆放。</translation>
    </message>
    <message>
        <source>Stand %1 is not aligned with the one that is worked on.</source>
        <translation>摆放 %1 未与当前处理的摆放对齐。</translation>
    </message>
    <message>
        <source>There is no erasure %1 to take back.</source>
        <translation>没有可恢复的擦除 %1。</translation>
    </message>
</context>
<context>
    <name>ReportPictures</name>
    <message>
        <source>Scan %1, position %2</source>
        <translation>扫描 %1，位置 %2</translation>
    </message>
    <message>
        <source>Scan %1</source>
        <translation>扫描 %1</translation>
    </message>
    <message>
        <source>Stand %1</source>
        <translation>摆放 %1</translation>
    </message>
    <message>
        <source>Stand %1, no scan</source>
        <translation>摆放 %1，无扫描</translation>
    </message>
</context>
<context>
    <name>ScannerPicture</name>
    <message>
        <source>surface</source>
        <translation>表面</translation>
    </message>
    <message>
        <source>too steep</source>
        <translation>过陡</translation>
    </message>
    <message>
        <source>receiver blocked</source>
        <translation>接收器被遮挡</translation>
    </message>
    <message>
        <source>void</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>inside</source>
        <translation>内部</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>无</translation>
    </message>
</context>
<context>
    <name>SessionDigest</name>
    <message>
        <source>no scan yet</source>
        <translation>尚无扫描</translation>
    </message>
    <message>
        <source>1 scan</source>
        <translation>1 个扫描</translation>
    </message>
    <message>
        <source>%1 scans</source>
        <translation>%1 个扫描</translation>
    </message>
    <message>
        <source>not ended, %1</source>
        <translation>未结束，%1</translation>
    </message>
    <message>
        <source>finished, %1</source>
        <translation>已完成，%1</translation>
    </message>
    <message>
        <source>ended by you, %1</source>
        <translation>由您结束，%1</translation>
    </message>
    <message>
        <source>imported, %1</source>
        <translation>已导入，%1</translation>
    </message>
    <message>
        <source>ended before all was seen, %1</source>
        <translation>未看全即结束，%1</translation>
    </message>
</context>
<context>
    <name>Settings</name>
    <message>
        <source>As it is</source>
        <translation>保持原样</translation>
    </message>
    <message>
        <source>Fitted</source>
        <translation>适配</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>采样间距</translation>
    </message>
    <message>
        <source>Triangle</source>
        <translation>三角形</translation>
    </message>
    <message>
        <source>Most views</source>
        <translation>最大视图数</translation>
    </message>
    <message>
        <source>Stop after so many views.</source>
        <translation>达到此视图数后停止。</translation>
    </message>
    <message>
        <source>First position</source>
        <translation>首个位置</translation>
    </message>
    <message>
        <source>Position of the workspace that the first scan is taken from.</source>
        <translation>首次扫描所用的工作空间位置。</translation>
    </message>
    <message>
        <source>Strategy</source>
        <translation>策略</translation>
    </message>
    <message>
        <source>How the next position is chosen: ps by positional space, uniform:N and random to compare with.</source>
        <translation>如何选择下一位置：ps 按位置空间，uniform:N 和 random 用于比较。</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>物体</translation>
    </message>
    <message>
        <source>Mesh that the simulated scanner looks at.</source>
        <translation>模拟扫描仪所看的网格。</translation>
    </message>
    <message>
        <source>Place object</source>
        <translation>放置物体</translation>
    </message>
    <message>
        <source>Take the mesh where it is, or scale and centre it into the viewing volume.</source>
        <translation>按网格原位使用，或缩放并居中到测量空间内。</translation>
    </message>
    <message>
        <source>Unit of the mesh</source>
        <translation>网格单位</translation>
    </message>
    <message>
        <source>Millimetres in a unit of the mesh file: 10 for centimetres, 25.4 for inches, 1000 for metres.</source>
        <translation>网格文件一个单位的毫米数：厘米为 10，英寸为 25.4，米为 1000。</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>随机种子</translation>
    </message>
    <message>
        <source>Seed of the simulated scanner&apos;s noise and mechanics.</source>
        <translation>模拟扫描仪噪声和机械误差的随机种子。</translation>
    </message>
    <message>
        <source>Ideal scanner</source>
        <translation>理想扫描仪</translation>
    </message>
    <message>
        <source>Switch the simulated noise and mechanical errors off.</source>
        <translation>关闭模拟的噪声和机械误差。</translation>
    </message>
    <message>
        <source>Least confidence</source>
        <translation>最小置信度</translation>
    </message>
    <message>
        <source>Surface sampled at a smaller cosine than this attracts another view; 0 switches it off.</source>
        <translation>以更小余弦采样的表面会吸引新的视图；0 表示关闭。</translation>
    </message>
    <message>
        <source>Least share of overlap</source>
        <translation>最小重叠比例</translation>
    </message>
    <message>
        <source>A view must overlap with at least this share of the model&apos;s area per view taken.</source>
        <translation>视图的重叠至少为每个已采集视图平均模型面积的此比例。</translation>
    </message>
    <message>
        <source>Least samples of overlap</source>
        <translation>最少重叠采样数</translation>
    </message>
    <message>
        <source>A view must overlap with at least the area of so many samples.</source>
        <translation>视图的重叠至少为这么多采样点的面积。</translation>
    </message>
    <message>
        <source>Least overlap</source>
        <translation>最小重叠</translation>
    </message>
    <message>
        <source>A view must overlap with the model by at least this area, in the place of share and samples.</source>
        <translation>视图与模型的重叠至少为此面积，代替比例和采样数。</translation>
    </message>
    <message>
        <source>mm2</source>
        <translation>mm²</translation>
    </message>
    <message>
        <source>Rings of the border</source>
        <translation>边界环数</translation>
    </message>
    <message>
        <source>Triangles this many rings of vertices from the model&apos;s border give no pairs to register a view with.</source>
        <translation>距模型边界这么多顶点环以内的三角形不提供配准用的点对。</translation>
    </message>
    <message>
        <source>Most relaxations</source>
        <translation>最多放宽次数</translation>
    </message>
    <message>
        <source>So often the least overlap is halved and the pose error doubled when no position satisfies them.</source>
        <translation>没有位置满足时，最小重叠减半、位姿误差加倍的次数。</translation>
    </message>
    <message>
        <source>By the table alone</source>
        <translation>仅凭转台</translation>
    </message>
    <message>
        <source>When nothing overlaps enough, a view that promises more than this share of the model&apos;s area is taken, placed by the table alone and called doubtful; 1: never.</source>
        <translation>当没有足够重叠时，若视图预期显示超过模型面积的此比例，则采集并仅凭转台定位，标为存疑；1：从不。</translation>
    </message>
    <message>
        <source>Pose certainty</source>
        <translation>位姿确定度</translation>
    </message>
    <message>
        <source>The overlap of a view must fix its pose to within this many sample spacings.</source>
        <translation>视图的重叠必须将其位姿确定到这么多采样间距以内。</translation>
    </message>
    <message>
        <source>samples</source>
        <translation>采样间距</translation>
    </message>
    <message>
        <source>Elements of overlap</source>
        <translation>重叠面元数</translation>
    </message>
    <message>
        <source>So many surface elements predict how certain the pose of a view would be.</source>
        <translation>用这么多面元预测视图位姿的确定程度。</translation>
    </message>
    <message>
        <source>Pairs per observation</source>
        <translation>每个观测的点对数</translation>
    </message>
    <message>
        <source>Neighbouring samples share errors: so many pairs of a registration count as one observation.</source>
        <translation>相邻采样点误差相关：配准中这么多点对算作一个观测。</translation>
    </message>
    <message>
        <source>Least error of a sample</source>
        <translation>采样点最小误差</translation>
    </message>
    <message>
        <source>Samples are taken to be no more exact than this, whatever the scanner&apos;s profile says.</source>
        <translation>无论扫描仪配置如何，采样点的精度不视为优于此值。</translation>
    </message>
    <message>
        <source>Look ahead</source>
        <translation>前瞻</translation>
    </message>
    <message>
        <source>Void patches stand for the surface behind them; off, the objective is that of the paper.</source>
        <translation>未知面片代表其后的表面；关闭时采用论文中的目标函数。</translation>
    </message>
    <message>
        <source>Reach of the look-ahead</source>
        <translation>前瞻距离</translation>
    </message>
    <message>
        <source>So far ahead an open void patch stands for unseen surface.</source>
        <translation>开放的未知面片代表前方这么远以内的未见表面。</translation>
    </message>
    <message>
        <source>Widest hole</source>
        <translation>最大孔洞</translation>
    </message>
    <message>
        <source>Patches that face each other across no more than this bound one hole.</source>
        <translation>相对距离不超过此值的面片围成一个孔洞。</translation>
    </message>
    <message>
        <source>Facing angle</source>
        <translation>相对角</translation>
    </message>
    <message>
        <source>Patches face each other when either lies this near to where the other points.</source>
        <translation>当每个面片都在另一个所指方向的此角度之内时，视为相对。</translation>
    </message>
    <message>
        <source>deg</source>
        <translation>度</translation>
    </message>
    <message>
        <source>Opening angle</source>
        <translation>开口角</translation>
    </message>
    <message>
        <source>A view that looks farther than this from the normal of an opening hardly looks through it.</source>
        <translation>视线与开口法线夹角超过此值时几乎看不进去。</translation>
    </message>
    <message>
        <source>Forecast surface</source>
        <translation>预测表面</translation>
    </message>
    <message>
        <source>Positions are ranked by the new surface that they are forecast to show, from a prediction of what closes the model; off, by void patches alone.</source>
        <translation>按预测可显示的新表面对位置排序，预测来自对模型封闭部分的估计；关闭时仅按未知面片。</translation>
    </message>
    <message>
        <source>Share of patches</source>
        <translation>面片比例</translation>
    </message>
    <message>
        <source>In a forecast void patches count by so much of their area beside the predicted surface.</source>
        <translation>在预测中，未知面片除预测表面外按其面积的此比例计入。</translation>
    </message>
    <message>
        <source>Share worth a forecast</source>
        <translation>值得预测的比例</translation>
    </message>
    <message>
        <source>A view must be forecast to show at least this share of the model&apos;s area.</source>
        <translation>视图的预测至少为模型面积的此比例。</translation>
    </message>
    <message>
        <source>Share worth a probe</source>
        <translation>值得试探的比例</translation>
    </message>
    <message>
        <source>After a view that showed enough, a forecast of this share of the termination threshold is tried; 1 never.</source>
        <translation>在一个显示足够的视图之后，尝试达到终止阈值此比例的预测；1 表示从不。</translation>
    </message>
    <message>
        <source>Offset from the surface</source>
        <translation>与表面的偏移</translation>
    </message>
    <message>
        <source>Lines of sight and observation rays begin this far in front of the surface.</source>
        <translation>视线和观测射线从表面前方这么远处开始。</translation>
    </message>
    <message>
        <source>Margin of sight</source>
        <translation>视线余量</translation>
    </message>
    <message>
        <source>What blocks a line of sight within this distance of either end does not count.</source>
        <translation>在视线两端此距离以内的遮挡不计。</translation>
    </message>
    <message>
        <source>Traced positions</source>
        <translation>追踪的位置数</translation>
    </message>
    <message>
        <source>So many positions at a time are judged with the scanner&apos;s own rays.</source>
        <translation>每次用扫描仪自身射线评判的位置数。</translation>
    </message>
    <message>
        <source>Planning triangles</source>
        <translation>规划三角形数</translation>
    </message>
    <message>
        <source>So many triangles stand for the model&apos;s surface when it is projected into positional space.</source>
        <translation>投影到位置空间时代表模型表面的三角形数。</translation>
    </message>
    <message>
        <source>Traced triangles</source>
        <translation>追踪三角形数</translation>
    </message>
    <message>
        <source>A model of more triangles than this is decimated before rays are traced through it.</source>
        <translation>三角形更多的模型在追踪射线前会被简化。</translation>
    </message>
    <message>
        <source>Error of decimation</source>
        <translation>简化误差</translation>
    </message>
    <message>
        <source>The decimated model is off by no more than this.</source>
        <translation>简化模型的偏差不超过此值。</translation>
    </message>
    <message>
        <source>Side of a voxel</source>
        <translation>体素边长</translation>
    </message>
    <message>
        <source>Unseen space is divided into voxels of this side.</source>
        <translation>未见空间按此边长划分为体素。</translation>
    </message>
    <message>
        <source>Crossing angle</source>
        <translation>交叉角</translation>
    </message>
    <message>
        <source>Two rays that measured nothing free what lies where they cross at no less than this angle.</source>
        <translation>两条未测到任何物体的射线以不小于此角交叉时，交叉处视为空。</translation>
    </message>
    <message>
        <source>Pull of silence</source>
        <translation>静默权重</translation>
    </message>
    <message>
        <source>A single ray that measured nothing makes what it passed so likely to be free, beside 6 for the neighbours.</source>
        <translation>单条未测到物体的射线使其所经之处为空的可能性权重，相邻体素为 6。</translation>
    </message>
    <message>
        <source>Most voxels</source>
        <translation>最多体素数</translation>
    </message>
    <message>
        <source>Voxels are larger where there would be more of them.</source>
        <translation>若体素会超过此数，则增大体素。</translation>
    </message>
    <message>
        <source>Clear of breakdown</source>
        <translation>与极限角的余量</translation>
    </message>
    <message>
        <source>A view should have sampled predicted surface that it saw this much inside the breakdown angle.</source>
        <translation>视图应已采样在极限角以内此余量看到的预测表面。</translation>
    </message>
    <message>
        <source>Sweeps</source>
        <translation>扫掠次数</translation>
    </message>
    <message>
        <source>So often the levels of unseen space are relaxed, a quarter of it after each look.</source>
        <translation>未见空间数值松弛的次数，每次查看后为其四分之一。</translation>
    </message>
    <message>
        <source>Most looks</source>
        <translation>最多查看次数</translation>
    </message>
    <message>
        <source>So often predicted surface that views should have sampled is carved away.</source>
        <translation>视图本应采样到的预测表面被去除的次数。</translation>
    </message>
    <message>
        <source>Views remembered</source>
        <translation>记住的视图数</translation>
    </message>
    <message>
        <source>So many of the last views correct a forecast.</source>
        <translation>用最近这么多视图校正预测。</translation>
    </message>
    <message>
        <source>Weight beforehand</source>
        <translation>先验权重</translation>
    </message>
    <message>
        <source>What is known beforehand of forecasts counts like a view that was forecast to show so many samples.</source>
        <translation>预测的先验相当于一个预测有这么多采样点的视图。</translation>
    </message>
    <message>
        <source>Share beforehand</source>
        <translation>先验比例</translation>
    </message>
    <message>
        <source>Share of what is forecast that is found, as far as is known beforehand.</source>
        <translation>事先所知预测中实际找到的比例。</translation>
    </message>
    <message>
        <source>Spread beforehand</source>
        <translation>先验离散度</translation>
    </message>
    <message>
        <source>Standard deviation of that share.</source>
        <translation>该比例的标准差。</translation>
    </message>
    <message>
        <source>Termination threshold</source>
        <translation>终止阈值</translation>
    </message>
    <message>
        <source>A view must promise at least this area of void, in the place of edges and share.</source>
        <translation>视图预期的未知面积至少为此值，代替边数和比例。</translation>
    </message>
    <message>
        <source>Edges worth a view</source>
        <translation>值得一个视图的边数</translation>
    </message>
    <message>
        <source>A view must promise what so many boundary edges of one sample spacing show.</source>
        <translation>视图的预期须达到这么多条一个采样间距长的边界边所显示的量。</translation>
    </message>
    <message>
        <source>Share worth a view</source>
        <translation>值得一个视图的比例</translation>
    </message>
    <message>
        <source>A view must promise at least this share of the model&apos;s area.</source>
        <translation>视图的预期至少为模型面积的此比例。</translation>
    </message>
    <message>
        <source>Share always worth a view</source>
        <translation>总值得一个视图的比例</translation>
    </message>
    <message>
        <source>A view that promises this share of the model&apos;s area is worth it, however small that is.</source>
        <translation>预期达到模型面积此比例的视图总是值得，无论面积多小。</translation>
    </message>
    <message>
        <source>A view has looked at a patch when it saw it this much inside the breakdown angle.</source>
        <translation>视图在极限角以内此余量看到面片时，视为已看过它。</translation>
    </message>
    <message>
        <source>After so many views that looked at it without finding surface a patch attracts no more.</source>
        <translation>经这么多视图查看而未发现表面后，面片不再吸引视图。</translation>
    </message>
    <message>
        <source>Gain of cosine</source>
        <translation>余弦增益</translation>
    </message>
    <message>
        <source>A patch attracts only views that see it at a cosine larger by this than any view before.</source>
        <translation>面片只吸引余弦比以往任何视图大此值的视图。</translation>
    </message>
    <message>
        <source>Grazing angle</source>
        <translation>掠射角</translation>
    </message>
    <message>
        <source>Views count as having seen a patch up to this angle, if only too steeply to sample it.</source>
        <translation>在此角以内面片视为已被看到，即使过陡而无法采样。</translation>
    </message>
    <message>
        <source>Jump factor</source>
        <translation>跳变系数</translation>
    </message>
    <message>
        <source>Surface beside an edge counts as a jump when it is so many times deeper than a surface at the breakdown angle falls off.</source>
        <translation>边旁的表面比极限角处的表面下降深这么多倍时，视为跳变。</translation>
    </message>
    <message>
        <source>Reach of shadows</source>
        <translation>阴影范围</translation>
    </message>
    <message>
        <source>So far beside an edge a shadow may begin that explains why nothing was sampled.</source>
        <translation>解释未采样原因的阴影可在边旁这么远以内开始。</translation>
    </message>
    <message>
        <source>Rings of normals</source>
        <translation>法线环数</translation>
    </message>
    <message>
        <source>The frame of an edge uses the mean normal of so many rings of triangles; 0 takes the edge&apos;s own.</source>
        <translation>边的坐标系使用这么多三角形环的平均法线；0 表示用边自身的法线。</translation>
    </message>
    <message>
        <source>Weight of a patch</source>
        <translation>面片权重</translation>
    </message>
    <message>
        <source>A void patch counts as edge length times sample spacing, or as the area of the edge&apos;s triangle.</source>
        <translation>未知面片按边长乘采样间距计，或按该边三角形的面积计。</translation>
    </message>
    <message>
        <source>Cut to the viewing volume</source>
        <translation>裁剪到测量空间</translation>
    </message>
    <message>
        <source>What a scan shows of the table, and of what stands outside of the viewing volume, is not used.</source>
        <translation>扫描中转台以及测量空间以外的部分不予使用。</translation>
    </message>
    <message>
        <source>Margin above the table</source>
        <translation>转台上方余量</translation>
    </message>
    <message>
        <source>What lies lower than this above the table is not used; auto follows spacing and noise of the samples.</source>
        <translation>低于转台上方此高度的部分不予使用；auto 随采样间距和噪声而定。</translation>
    </message>
    <message>
        <source>Margin inside the radius</source>
        <translation>半径内余量</translation>
    </message>
    <message>
        <source>The cut is so much narrower than the viewing volume.</source>
        <translation>裁剪范围比测量空间窄此值。</translation>
    </message>
    <message>
        <source>Drop flying samples</source>
        <translation>去除飞点</translation>
    </message>
    <message>
        <source>Samples that lie between front and back of an edge are not used.</source>
        <translation>位于边缘前后之间的采样点不予使用。</translation>
    </message>
    <message>
        <source>Jump of a flying sample</source>
        <translation>飞点跳变</translation>
    </message>
    <message>
        <source>Neighbours are apart by a jump when they are farther from each other than so many times what surface at the breakdown angle explains.</source>
        <translation>相邻点间距超过极限角表面所能解释的这么多倍时，视为跳变。</translation>
    </message>
    <message>
        <source>Drop isolated samples</source>
        <translation>去除孤立点</translation>
    </message>
    <message>
        <source>Samples that no neighbour belongs to are not used.</source>
        <translation>没有相邻点的采样点不予使用。</translation>
    </message>
    <message>
        <source>Smallest piece of a scan</source>
        <translation>扫描的最小部分</translation>
    </message>
    <message>
        <source>Pieces of a scan of fewer samples are not used.</source>
        <translation>采样点更少的扫描部分不予使用。</translation>
    </message>
    <message>
        <source>Spacing worked with</source>
        <translation>处理用间距</translation>
    </message>
    <message>
        <source>Samples nearer to each other than this are thinned by whole rows and columns, in what is worked on and not in what is kept; 0: none are; auto: those of a scanner with more than 1.5 million rays.</source>
        <translation>比此值更近的采样点在处理时按整行整列抽稀，保存的数据不变；0：不抽稀；auto：用于超过 150 万条射线的扫描仪。</translation>
    </message>
    <message>
        <source>Slack of the breakdown angle</source>
        <translation>极限角余量</translation>
    </message>
    <message>
        <source>How much farther than the breakdown angle noise may tilt a single triangle.</source>
        <translation>噪声可使单个三角形倾斜超出极限角的量。</translation>
    </message>
    <message>
        <source>Discontinuity factor</source>
        <translation>不连续系数</translation>
    </message>
    <message>
        <source>An edge is a jump in depth when it is so many times longer than that of a surface at the breakdown angle.</source>
        <translation>边长超过极限角表面边长的这么多倍时，视为深度跳变。</translation>
    </message>
    <message>
        <source>Coarse gate</source>
        <translation>粗配门限</translation>
    </message>
    <message>
        <source>Largest distance of a pair at the beginning; auto follows the size of what a scan shows.</source>
        <translation>开始时点对的最大距离；auto 随扫描内容大小而定。</translation>
    </message>
    <message>
        <source>Final gate</source>
        <translation>最终门限</translation>
    </message>
    <message>
        <source>Largest distance of a pair at the end; auto follows spacing and noise of the samples.</source>
        <translation>结束时点对的最大距离；auto 随采样间距和噪声而定。</translation>
    </message>
    <message>
        <source>Coarse angle</source>
        <translation>粗配角</translation>
    </message>
    <message>
        <source>Largest angle between the normals of a pair at the beginning.</source>
        <translation>开始时点对法线间的最大夹角。</translation>
    </message>
    <message>
        <source>Final angle</source>
        <translation>最终角</translation>
    </message>
    <message>
        <source>Largest angle between the normals of a pair at the end.</source>
        <translation>结束时点对法线间的最大夹角。</translation>
    </message>
    <message>
        <source>Hidden depth</source>
        <translation>遮挡深度</translation>
    </message>
    <message>
        <source>Model surface farther behind the view&apos;s counts as hidden; auto follows the size of what a scan shows.</source>
        <translation>比视图表面更靠后超过此值的模型表面视为被遮挡；auto 随扫描内容大小而定。</translation>
    </message>
    <message>
        <source>Coarse points</source>
        <translation>粗配点数</translation>
    </message>
    <message>
        <source>Points of the model that are looked up until the pose settles.</source>
        <translation>位姿稳定之前查找的模型点数。</translation>
    </message>
    <message>
        <source>Fine points</source>
        <translation>精配点数</translation>
    </message>
    <message>
        <source>Points of the model that are looked up in the last rounds.</source>
        <translation>最后几轮查找的模型点数。</translation>
    </message>
    <message>
        <source>Most rounds</source>
        <translation>最多轮数</translation>
    </message>
    <message>
        <source>Rounds after which a registration is given up.</source>
        <translation>配准放弃之前的轮数。</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>容差</translation>
    </message>
    <message>
        <source>The pose has settled when points move less than this.</source>
        <translation>点移动小于此值时位姿视为稳定。</translation>
    </message>
    <message>
        <source>Search for rivals</source>
        <translation>查找竞争位姿</translation>
    </message>
    <message>
        <source>Look for other poses that fit as well, as repetitive shapes have them.</source>
        <translation>查找同样吻合的其他位姿，重复的形状会有这种情况。</translation>
    </message>
    <message>
        <source>Least pairs</source>
        <translation>最少点对</translation>
    </message>
    <message>
        <source>With fewer pairs a registration has failed.</source>
        <translation>点对更少则配准失败。</translation>
    </message>
    <message>
        <source>Few pairs</source>
        <translation>点对偏少</translation>
    </message>
    <message>
        <source>With fewer pairs a registration is doubtful.</source>
        <translation>点对更少则配准存疑。</translation>
    </message>
    <message>
        <source>Least share of inliers</source>
        <translation>最小内点比例</translation>
    </message>
    <message>
        <source>With less of the expected overlap a registration has failed.</source>
        <translation>预期重叠低于此比例则配准失败。</translation>
    </message>
    <message>
        <source>Low share of inliers</source>
        <translation>内点比例偏低</translation>
    </message>
    <message>
        <source>With less of the expected overlap a registration is doubtful.</source>
        <translation>预期重叠低于此比例则配准存疑。</translation>
    </message>
    <message>
        <source>Doubtful conflicts</source>
        <translation>存疑的矛盾</translation>
    </message>
    <message>
        <source>With a larger share of points that the scanner looked through a registration is doubtful.</source>
        <translation>扫描仪看穿的点超过此比例则配准存疑。</translation>
    </message>
    <message>
        <source>Most conflicts</source>
        <translation>最大矛盾</translation>
    </message>
    <message>
        <source>With a larger share of points that the scanner looked through a registration has failed.</source>
        <translation>扫描仪看穿的点超过此比例则配准失败。</translation>
    </message>
    <message>
        <source>Doubtful residual</source>
        <translation>存疑的残差</translation>
    </message>
    <message>
        <source>With a residual of more than so many times what noise and spacing explain a registration is doubtful.</source>
        <translation>残差超过噪声和间距所能解释的这么多倍则配准存疑。</translation>
    </message>
    <message>
        <source>Largest residual</source>
        <translation>最大残差</translation>
    </message>
    <message>
        <source>With a residual of more than so many times what noise and spacing explain a registration has failed.</source>
        <translation>残差超过噪声和间距所能解释的这么多倍则配准失败。</translation>
    </message>
    <message>
        <source>Doubtful motion</source>
        <translation>存疑的移动</translation>
    </message>
    <message>
        <source>Farther from the start pose than so many sigmas of the prior a registration is doubtful.</source>
        <translation>离起始位姿超过先验的这么多 σ 则配准存疑。</translation>
    </message>
    <message>
        <source>Largest motion</source>
        <translation>最大移动</translation>
    </message>
    <message>
        <source>Farther from the start pose than so many sigmas of the prior a registration has failed.</source>
        <translation>离起始位姿超过先验的这么多 σ 则配准失败。</translation>
    </message>
    <message>
        <source>Tolerance of held scans</source>
        <translation>受约束扫描的容差</translation>
    </message>
    <message>
        <source>Where the mechanics alone hold a motion of a scan, it has failed when conflicts or residual exceed so many times what is doubtful.</source>
        <translation>若扫描的某一移动仅由机械约束，当矛盾或残差超过存疑值的这么多倍时失败。</translation>
    </message>
    <message>
        <source>Largest pose sigma</source>
        <translation>最大位姿 σ</translation>
    </message>
    <message>
        <source>With a less certain pose, going by the pairs alone, a registration is doubtful; auto follows the spacing.</source>
        <translation>仅按点对，位姿更不确定则配准存疑；auto 随采样间距而定。</translation>
    </message>
    <message>
        <source>Largest distance of a pair at the beginning; auto follows the final gate.</source>
        <translation>开始时点对的最大距离；auto 随最终门限而定。</translation>
    </message>
    <message>
        <source>Largest angle</source>
        <translation>最大角</translation>
    </message>
    <message>
        <source>Largest angle between the normals of a pair.</source>
        <translation>点对法线间的最大夹角。</translation>
    </message>
    <message>
        <source>Surface farther behind another view&apos;s counts as hidden; auto follows the size of what a scan shows.</source>
        <translation>比另一视图表面更靠后超过此值的表面视为被遮挡；auto 随扫描内容大小而定。</translation>
    </message>
    <message>
        <source>Share of a view&apos;s points that must meet another view for the two to be tied.</source>
        <translation>视图中须与另一视图相遇的点的比例，二者才建立联系。</translation>
    </message>
    <message>
        <source>Points that are looked up per round until the poses settle.</source>
        <translation>位姿稳定之前每轮查找的点数。</translation>
    </message>
    <message>
        <source>Points that are looked up in the last rounds.</source>
        <translation>最后几轮查找的点数。</translation>
    </message>
    <message>
        <source>Least points</source>
        <translation>最少点数</translation>
    </message>
    <message>
        <source>Points that each direction of a pair of views gets at least.</source>
        <translation>一对视图的每个方向至少得到的点数。</translation>
    </message>
    <message>
        <source>Rounds after which the refinement is given up.</source>
        <translation>精化放弃之前的轮数。</translation>
    </message>
    <message>
        <source>The poses have settled when points move less than this.</source>
        <translation>点移动小于此值时位姿视为稳定。</translation>
    </message>
    <message>
        <source>Points per view</source>
        <translation>每个视图的点数</translation>
    </message>
    <message>
        <source>Points of every placed view that the next recorded scan is registered against.</source>
        <translation>每个已定位视图中用于配准下一录制扫描的点数。</translation>
    </message>
    <message>
        <source>Points that are looked up in the last rounds of the registration of a recorded scan.</source>
        <translation>录制扫描配准最后几轮查找的点数。</translation>
    </message>
    <message>
        <source>Surface tolerance</source>
        <translation>表面容差</translation>
    </message>
    <message>
        <source>Two surfaces that face the same way and are no farther apart than this are one.</source>
        <translation>朝向相同且相距不超过此值的两个表面视为同一个。</translation>
    </message>
    <message>
        <source>Spacing tolerance</source>
        <translation>间距容差</translation>
    </message>
    <message>
        <source>Two surfaces are also one when they are no farther apart than so many sample spacings of the new view.</source>
        <translation>相距不超过新视图这么多采样间距的两个表面也视为同一个。</translation>
    </message>
    <message>
        <source>Normal tolerance</source>
        <translation>法线容差</translation>
    </message>
    <message>
        <source>Two surfaces face the same way when their normals enclose no more than this.</source>
        <translation>法线夹角不超过此值的两个表面朝向相同。</translation>
    </message>
    <message>
        <source>Steepest surface</source>
        <translation>最陡表面</translation>
    </message>
    <message>
        <source>Surface that leans farther than this from the new view&apos;s rays is not compared with it.</source>
        <translation>相对新视图射线倾斜超过此值的表面不与之比较。</translation>
    </message>
    <message>
        <source>Margin of confidence</source>
        <translation>置信度余量</translation>
    </message>
    <message>
        <source>The new view&apos;s confidence must exceed the model&apos;s by this for its surface to replace the model&apos;s.</source>
        <translation>新视图的置信度须超过模型此值，其表面才会取代模型表面。</translation>
    </message>
    <message>
        <source>Clearance of the seam</source>
        <translation>接缝间隙</translation>
    </message>
    <message>
        <source>Samples of the new view nearer than this to the model&apos;s border are left out of the seam.</source>
        <translation>距模型边界小于此值的新视图采样点不参与接缝。</translation>
    </message>
    <message>
        <source>A seam edge so many times longer than that of a surface at the breakdown angle is a gap.</source>
        <translation>接缝边长超过极限角表面边长的这么多倍时为缺口。</translation>
    </message>
    <message>
        <source>Shortest edge</source>
        <translation>最短边</translation>
    </message>
    <message>
        <source>Edges at the seam that are shorter than this are collapsed.</source>
        <translation>接缝处短于此值的边被收缩。</translation>
    </message>
    <message>
        <source>Edges of a hole</source>
        <translation>孔洞边数</translation>
    </message>
    <message>
        <source>Holes with no more edges than this are closed where the views have seen surface.</source>
        <translation>边数不超过此值的孔洞在视图看到表面处封闭。</translation>
    </message>
    <message>
        <source>Chord of a hole</source>
        <translation>孔洞弦长</translation>
    </message>
    <message>
        <source>Holes are closed when that takes no edge longer than this.</source>
        <translation>封闭所需的边不长于此值时才封闭孔洞。</translation>
    </message>
    <message>
        <source>Smallest piece</source>
        <translation>最小部分</translation>
    </message>
    <message>
        <source>Pieces of fewer triangles are dropped.</source>
        <translation>三角形更少的部分被去除。</translation>
    </message>
    <message>
        <source>Mend</source>
        <translation>修补</translation>
    </message>
    <message>
        <source>Openings of a model of recorded scans are closed where a view has measured surface, and crumbs go.</source>
        <translation>录制扫描模型的开口在有视图测得表面处封闭，碎片被去除。</translation>
    </message>
    <message>
        <source>Largest offset</source>
        <translation>最大偏移</translation>
    </message>
    <message>
        <source>A view&apos;s surface farther than this along a vertex&apos;s normal is another surface.</source>
        <translation>沿顶点法线距离超过此值的视图表面视为另一表面。</translation>
    </message>
    <message>
        <source>Offset in spacings</source>
        <translation>以间距计的偏移</translation>
    </message>
    <message>
        <source>A view&apos;s surface within so many of its sample spacings is never another surface.</source>
        <translation>在视图这么多采样间距以内的表面不会视为另一表面。</translation>
    </message>
    <message>
        <source>A view has no say when the normals enclose more than this.</source>
        <translation>法线夹角超过此值时视图不参与。</translation>
    </message>
    <message>
        <source>Passes</source>
        <translation>遍数</translation>
    </message>
    <message>
        <source>How often the vertices are moved.</source>
        <translation>顶点移动的次数。</translation>
    </message>
    <message>
        <source>Acquisition</source>
        <translation>采集</translation>
    </message>
    <message>
        <source>Simulated scanner</source>
        <translation>模拟扫描仪</translation>
    </message>
    <message>
        <source>Planning</source>
        <translation>规划</translation>
    </message>
    <message>
        <source>Predicted surface</source>
        <translation>预测表面</translation>
    </message>
    <message>
        <source>Ledger of forecasts</source>
        <translation>预测记录</translation>
    </message>
    <message>
        <source>Termination</source>
        <translation>终止</translation>
    </message>
    <message>
        <source>What views have looked at</source>
        <translation>视图已查看的部分</translation>
    </message>
    <message>
        <source>Void patches</source>
        <translation>未知面片</translation>
    </message>
    <message>
        <source>What is not the object</source>
        <translation>非物体部分</translation>
    </message>
    <message>
        <source>Surface of a scan</source>
        <translation>扫描的表面</translation>
    </message>
    <message>
        <source>Registration</source>
        <translation>配准</translation>
    </message>
    <message>
        <source>Verdict on a registration</source>
        <translation>配准的判定</translation>
    </message>
    <message>
        <source>Refinement of all poses</source>
        <translation>所有位姿的精化</translation>
    </message>
    <message>
        <source>Import of recorded scans</source>
        <translation>导入录制的扫描</translation>
    </message>
    <message>
        <source>Integration</source>
        <translation>集成</translation>
    </message>
    <message>
        <source>Consensus</source>
        <translation>一致性</translation>
    </message>
</context>
<context>
    <name>StandPoses</name>
    <message>
        <source>the evidence decided</source>
        <translation>由证据决定</translation>
    </message>
    <message>
        <source>you chose the pose</source>
        <translation>由您选择位姿</translation>
    </message>
    <message>
        <source>you use the pose although something speaks against it; the report says so</source>
        <translation>尽管有不利证据您仍使用此位姿；报告会说明</translation>
    </message>
    <message>
        <source>Pick the same points on both, or scan more of this stand.</source>
        <translation>请在两者上选取相同的点，或对此摆放再多扫描。</translation>
    </message>
    <message>
        <source>Look at the poses, pick the same points on both, or scan more of this stand.</source>
        <translation>请查看位姿，在两者上选取相同的点，或对此摆放再多扫描。</translation>
    </message>
    <message>
        <source>It makes no difference which of them you use.</source>
        <translation>用哪一个都没有区别。</translation>
    </message>
    <message>
        <source>Use the pose if the motion does not matter, or scan a stand that shows more.</source>
        <translation>如果该移动无关紧要，请使用此位姿，或扫描显示更多的摆放。</translation>
    </message>
    <message>
        <source>Look at them and use the right one, or scan more.</source>
        <translation>请查看并使用正确的那个，或再多扫描。</translation>
    </message>
    <message>
        <source>Stand %1 is in place.</source>
        <translation>摆放 %1 已就位。</translation>
    </message>
    <message>
        <source>Stand %1 has not been aligned yet: look for poses, or pick the same points on both.</source>
        <translation>摆放 %1 尚未对齐：请查找位姿，或在两者上选取相同的点。</translation>
    </message>
    <message>
        <source>Stand %1 is in place: %2, %3.</source>
        <translation>摆放 %1 已就位：%2，%3。</translation>
    </message>
    <message>
        <source>Stand %1 is not in place: %2. %3</source>
        <translation>摆放 %1 未就位：%2。%3</translation>
    </message>
    <message>
        <source>Pose %1, possible</source>
        <translation>位姿 %1，可能</translation>
    </message>
    <message>
        <source>Pose %1, unlikely</source>
        <translation>位姿 %1，不太可能</translation>
    </message>
    <message>
        <source>%1 % in common, %2 mm apart
%3 % contradicted
%4 % expected, not seen</source>
        <translation>共有 %1 %，相距 %2 mm
矛盾 %3 %
应见而未见 %4 %</translation>
    </message>
</context>
<context>
    <name>Stands</name>
    <message>
        <source>reference</source>
        <translation>基准</translation>
    </message>
    <message>
        <source>aligned</source>
        <translation>已对齐</translation>
    </message>
    <message>
        <source>doubtful</source>
        <translation>存疑</translation>
    </message>
    <message>
        <source>used all the same</source>
        <translation>仍然使用</translation>
    </message>
    <message>
        <source>not aligned</source>
        <translation>未对齐</translation>
    </message>
    <message>
        <source>Stand %1 is aligned: %2.</source>
        <translation>摆放 %1 已对齐：%2。</translation>
    </message>
    <message>
        <source>Stand %1 is not aligned, the scans leave it open: %2.</source>
        <translation>摆放 %1 未对齐，扫描无法确定：%2。</translation>
    </message>
    <message>
        <source>Stand %1 could not be aligned: %2.</source>
        <translation>摆放 %1 未能对齐：%2。</translation>
    </message>
    <message>
        <source>Stand %1 is the reference: the object stands in the model as it stood here.</source>
        <translation>摆放 %1 是基准：模型中物体的姿态即此摆放。</translation>
    </message>
    <message>
        <source>Stand %1 is where the operator placed it.</source>
        <translation>摆放 %1 位于操作者放置之处。</translation>
    </message>
    <message>
        <source>Stand %1 is in the model by a pose that was chosen: %2.</source>
        <translation>摆放 %1 按所选位姿加入模型：%2。</translation>
    </message>
    <message>
        <source>Stand %1 is in the model although something speaks against it: %2.</source>
        <translation>摆放 %1 在模型中，尽管有不利证据：%2。</translation>
    </message>
    <message>
        <source>Stand %1 is a model of its own: it is not put together with the object yet.</source>
        <translation>摆放 %1 自成一个模型：尚未与物体合为一体。</translation>
    </message>
    <message>
        <source>Stand %1, not put together with the object yet</source>
        <translation>摆放 %1，尚未与物体合为一体</translation>
    </message>
    <message>
        <source>Stand %1 is not in it: it is not put together with the object.</source>
        <translation>摆放 %1 不在其中：未与物体合为一体。</translation>
    </message>
    <message>
        <source>Stands %1 are not in it: they are not put together with the object.</source>
        <translation>摆放 %1 不在其中：未与物体合为一体。</translation>
    </message>
</context>
<context>
    <name>TestScanBox</name>
    <message>
        <source>Table</source>
        <translation>转台</translation>
    </message>
    <message>
        <source>Outside of the volume</source>
        <translation>空间之外</translation>
    </message>
    <message>
        <source>Flying samples</source>
        <translation>飞点</translation>
    </message>
    <message>
        <source>Isolated samples</source>
        <translation>孤立点</translation>
    </message>
    <message>
        <source>Small pieces</source>
        <translation>小块</translation>
    </message>
    <message>
        <source>Used</source>
        <translation>已使用</translation>
    </message>
    <message>
        <source>Without a sample</source>
        <translation>无采样</translation>
    </message>
</context>
<context>
    <name>TimeLine</name>
    <message>
        <source>Scan %1 · position %2
did not fit</source>
        <translation>扫描 %1 · 位置 %2
未吻合</translation>
    </message>
    <message>
        <source>Scan %1 · position %2
+%3</source>
        <translation>扫描 %1 · 位置 %2
+%3</translation>
    </message>
</context>
<context>
    <name>ToolNotes</name>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1 (along x %2, y %3, z %4)</source>
        <translation>%1（沿 x %2，y %3，z %4）</translation>
    </message>
    <message>
        <source>The plane cuts nothing.</source>
        <translation>平面没有切到任何部分。</translation>
    </message>
    <message>
        <source>The outline is open, %1 long.</source>
        <translation>轮廓开放，长 %1。</translation>
    </message>
    <message>
        <source>The outline is closed, %1 long, and encloses %2 mm².</source>
        <translation>轮廓封闭，长 %1，围成 %2 mm²。</translation>
    </message>
    <message>
        <source>Clipped: shown is what has %1</source>
        <translation>已剖切：显示 %1 的部分</translation>
    </message>
    <message>
        <source>As a wireframe</source>
        <translation>以线框显示</translation>
    </message>
    <message>
        <source>As points</source>
        <translation>以点显示</translation>
    </message>
    <message>
        <source>Back faces are red</source>
        <translation>背面为红色</translation>
    </message>
    <message>
        <source>In parallel projection</source>
        <translation>平行投影</translation>
    </message>
    <message>
        <source>1 to 2: %1</source>
        <translation>1 至 2：%1</translation>
    </message>
    <message>
        <source>Place %1: click the surface, or Enter takes the middle of the view</source>
        <translation>第 %1 处：点击表面，或按 Enter 取视图中央</translation>
    </message>
</context>
<context>
    <name>WhyCard</name>
    <message>
        <source>Your choice: the next scan is taken from here. </source>
        <translation>您的选择：下一次扫描由此进行。</translation>
    </message>
    <message>
        <source>Next, as the scan before did not fit: this one overlaps the model clearly more. </source>
        <translation>下一个，因为上一次扫描未吻合：此处与模型的重叠明显更多。</translation>
    </message>
    <message>
        <source>The acquisition has ended; if it went on, this would be next. </source>
        <translation>采集已结束；如果继续，下一个就是它。</translation>
    </message>
    <message>
        <source>A scan from here did not fit. </source>
        <translation>由此进行的一次扫描未吻合。</translation>
    </message>
    <message>
        <source>It shows the most unseen surface. Nothing that is left overlaps the model enough to register with it: the table alone will say where this scan belongs.</source>
        <translation>它显示最多的未见表面。剩余位置与模型的重叠都不足以配准：此扫描的归属将仅由转台确定。</translation>
    </message>
    <message>
        <source>Proposed: of all positions that overlap the model enough it shows the most unseen surface.</source>
        <translation>建议：在所有与模型重叠足够的位置中，它显示最多的未见表面。</translation>
    </message>
    <message>
        <source>Of all positions that overlap the model enough it shows the most unseen surface; after a scan that did not fit another one comes next.</source>
        <translation>在所有与模型重叠足够的位置中，它显示最多的未见表面；因为有一次扫描未吻合，下一个是另一位置。</translation>
    </message>
    <message>
        <source>Allowed, but the proposed position shows more.</source>
        <translation>允许，但建议的位置显示更多。</translation>
    </message>
    <message>
        <source>Allowed.</source>
        <translation>允许。</translation>
    </message>
    <message>
        <source>Rejected: what it would show is %1 short of the least that is worth a scan.</source>
        <translation>拒绝：可显示的部分比值得扫描的最小值少 %1。</translation>
    </message>
    <message>
        <source> It overlaps the model too little to be registered, too.</source>
        <translation>它与模型的重叠也不足以配准。</translation>
    </message>
    <message>
        <source>Rejected: the overlap with the model is short by %1, so the scan could not be registered.</source>
        <translation>拒绝：与模型的重叠少 %1，扫描无法配准。</translation>
    </message>
    <message>
        <source>Rejected: registration would be uncertain, by %1 mm more than allowed.</source>
        <translation>拒绝：配准不确定，超出允许值 %1 mm。</translation>
    </message>
    <message>
        <source>New surface, as forecast (o_v)</source>
        <translation>预测的新表面 (o_v)</translation>
    </message>
    <message>
        <source>Would show (void, o_v)</source>
        <translation>可显示（未知，o_v）</translation>
    </message>
    <message>
        <source>less than F = %1: a probe, as the last scan showed more</source>
        <translation>小于 F = %1：试探，因为上次扫描显示更多</translation>
    </message>
    <message>
        <source>more than F = %1 is worth a scan</source>
        <translation>大于 F = %1 值得扫描</translation>
    </message>
    <message>
        <source>by positional space</source>
        <translation>按位置空间</translation>
    </message>
    <message>
        <source>before following the scanner&apos;s rays</source>
        <translation>追踪扫描仪射线之前</translation>
    </message>
    <message>
        <source>Rank</source>
        <translation>排名</translation>
    </message>
    <message>
        <source>by what positions promise, ruled out or not</source>
        <translation>按各位置的预期，无论是否排除</translation>
    </message>
    <message>
        <source>Overlap (o_s)</source>
        <translation>重叠 (o_s)</translation>
    </message>
    <message>
        <source>too little to register with</source>
        <translation>不足以配准</translation>
    </message>
    <message>
        <source>more than t = %1 is needed</source>
        <translation>需大于 t = %1</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>unbounded</source>
        <translation>无界</translation>
    </message>
    <message>
        <source>Registration error</source>
        <translation>配准误差</translation>
    </message>
    <message>
        <source>weakest: %1</source>
        <translation>最弱：%1</translation>
    </message>
    <message>
        <source>Unseen edges it wins</source>
        <translation>可获得的未见边</translation>
    </message>
    <message>
        <source>1 edge</source>
        <translation>1 条边</translation>
    </message>
    <message>
        <source>%1 edges</source>
        <translation>%1 条边</translation>
    </message>
    <message>
        <source>in sight</source>
        <translation>可见</translation>
    </message>
    <message>
        <source>light blocked by the object</source>
        <translation>光线被物体遮挡</translation>
    </message>
    <message>
        <source>receiver blocked by the object</source>
        <translation>接收器被物体遮挡</translation>
    </message>
    <message>
        <source>too steep</source>
        <translation>过陡</translation>
    </message>
    <message>
        <source>outside the sampling area</source>
        <translation>采样区域之外</translation>
    </message>
    <message>
        <source>No other position is allowed.</source>
        <translation>没有其他允许的位置。</translation>
    </message>
    <message>
        <source>The runner-up, position %1,</source>
        <translation>次优的位置 %1 </translation>
    </message>
    <message>
        <source>The proposed position %1</source>
        <translation>建议的位置 %1 </translation>
    </message>
    <message>
        <source>Position %1, which the plan had proposed,</source>
        <translation>规划曾建议的位置 %1 </translation>
    </message>
    <message>
        <source>%1 shows %2 and overlaps %3.</source>
        <translation>%1显示%2，重叠%3。</translation>
    </message>
    <message>
        <source>more</source>
        <translation>更多</translation>
    </message>
    <message>
        <source>less</source>
        <translation>更少</translation>
    </message>
    <message>
        <source>Position %1</source>
        <translation>位置 %1</translation>
    </message>
    <message>
        <source> The model here is that of stand %1 alone, which is not put together with the object yet.</source>
        <translation>此处的模型仅为摆放 %1，尚未与物体合为一体。</translation>
    </message>
</context>
<context>
    <name>Wording</name>
    <message>
        <source>The acquisition is not ended yet.</source>
        <translation>采集尚未结束。</translation>
    </message>
    <message>
        <source>Ended: no position would show more than is worth a scan.</source>
        <translation>已结束：没有位置能显示值得扫描的内容。</translation>
    </message>
    <message>
        <source>Ended: what is left overlaps the model too little from every position.</source>
        <translation>已结束：从任何位置看，剩余部分与模型的重叠都太少。</translation>
    </message>
    <message>
        <source>Ended: the greatest number of views was taken.</source>
        <translation>已结束：已采集最大视图数。</translation>
    </message>
    <message>
        <source>Ended: scans could not be registered.</source>
        <translation>已结束：扫描无法配准。</translation>
    </message>
    <message>
        <source>The run was stopped.</source>
        <translation>运行已停止。</translation>
    </message>
    <message>
        <source>Ended by you.</source>
        <translation>由您结束。</translation>
    </message>
    <message>
        <source>Recorded scans, put together. No view was planned, so nothing is known of what is left.</source>
        <translation>录制的扫描已合并。没有规划视图，因此对剩余部分一无所知。</translation>
    </message>
    <message>
        <source>No ray reaches it</source>
        <translation>没有射线可及</translation>
    </message>
    <message>
        <source>Too steep from everywhere</source>
        <translation>从任何位置看都过陡</translation>
    </message>
    <message>
        <source>Light always blocked</source>
        <translation>光线总被遮挡</translation>
    </message>
    <message>
        <source>Receiver always blocked</source>
        <translation>接收器总被遮挡</translation>
    </message>
    <message>
        <source>Not scanned yet</source>
        <translation>尚未扫描</translation>
    </message>
    <message>
        <source>Too little to be worth it</source>
        <translation>太少，不值得</translation>
    </message>
    <message>
        <source>Looked at, no surface</source>
        <translation>已看过，没有表面</translation>
    </message>
    <message>
        <source>edge against the background</source>
        <translation>背景前的边</translation>
    </message>
    <message>
        <source>hidden behind the object</source>
        <translation>被物体遮挡</translation>
    </message>
    <message>
        <source>light or camera blocked</source>
        <translation>光线或相机被遮挡</translation>
    </message>
    <message>
        <source>open border</source>
        <translation>开放边界</translation>
    </message>
    <message>
        <source>rim of the scan</source>
        <translation>扫描边缘</translation>
    </message>
    <message>
        <source>Erased by you</source>
        <translation>由您擦除</translation>
    </message>
</context>
<context>
    <name>vantage::AcquirePage</name>
    <message>
        <source>Tr&amp;y again</source>
        <translation>再试一次(&amp;Y)</translation>
    </message>
    <message>
        <source>Scan from the same position once more.</source>
        <translation>从同一位置再扫描一次。</translation>
    </message>
    <message>
        <source>Turn it &amp;myself</source>
        <translation>自己转动(&amp;M)</translation>
    </message>
    <message>
        <source>Go on without the table: you turn the object as the dial says.</source>
        <translation>不用转台继续：由您按刻度盘转动物体。</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>运行(&amp;R)</translation>
    </message>
    <message>
        <source>Scan until nothing is left to see.</source>
        <translation>一直扫描到没有可看的为止。</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>暂停(&amp;P)</translation>
    </message>
    <message>
        <source>Stop after the scan that is under way.</source>
        <translation>当前扫描完成后停止。</translation>
    </message>
    <message>
        <source>&amp;One scan</source>
        <translation>单次扫描(&amp;O)</translation>
    </message>
    <message>
        <source>Take the next scan and stop.</source>
        <translation>进行下一次扫描后停止。</translation>
    </message>
    <message>
        <source>S&amp;top</source>
        <translation>停止(&amp;T)</translation>
    </message>
    <message>
        <source>Stop at once; the scan that is under way leaves no trace.</source>
        <translation>立即停止；当前扫描不留痕迹。</translation>
    </message>
    <message>
        <source>The table &amp;is turned: scan</source>
        <translation>转台已转好：扫描(&amp;I)</translation>
    </message>
    <message>
        <source>Scan from the position shown.</source>
        <translation>从显示的位置扫描。</translation>
    </message>
    <message>
        <source>Allow %1 &amp;further views</source>
        <translation>允许再采集 %1 个视图(&amp;F)</translation>
    </message>
    <message>
        <source>Raise the greatest number of views, so that you can go on.</source>
        <translation>提高最大视图数，以便继续。</translation>
    </message>
    <message>
        <source>En&amp;d here</source>
        <translation>在此结束(&amp;D)</translation>
    </message>
    <message>
        <source>End the acquisition with what has been scanned.</source>
        <translation>以已扫描的内容结束采集。</translation>
    </message>
    <message>
        <source>T&amp;urn over…</source>
        <translation>翻转(&amp;U)…</translation>
    </message>
    <message>
        <source>Put the object on another side, to scan what this stand hides.</source>
        <translation>将物体换一面放置，以扫描此摆放遮住的部分。</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>Assisted</source>
        <translation>协助</translation>
    </message>
    <message>
        <source>Who turns the table</source>
        <translation>由谁转动转台</translation>
    </message>
    <message>
        <source>So far</source>
        <translation>到目前为止</translation>
    </message>
    <message>
        <source>Scanning, registering, merging and planning; the bar below shows the step.</source>
        <translation>扫描、配准、合并和规划；下方的进度条显示当前步骤。</translation>
    </message>
    <message>
        <source>Now: %1.</source>
        <translation>当前：%1。</translation>
    </message>
    <message>
        <source>Stops after this scan.</source>
        <translation>此次扫描后停止。</translation>
    </message>
    <message>
        <source>Stopping.</source>
        <translation>正在停止。</translation>
    </message>
    <message>
        <source>Reading scanner and object.</source>
        <translation>正在读取扫描仪和物体。</translation>
    </message>
    <message>
        <source>Nothing has been scanned yet.</source>
        <translation>尚未扫描任何内容。</translation>
    </message>
    <message>
        <source>Stopped. The next view is ready.</source>
        <translation>已停止。下一视图已就绪。</translation>
    </message>
    <message>
        <source>While this stand is scanned it is found out how the object was turned over; then both are one model.</source>
        <translation>扫描此摆放时会找出物体是如何翻转的；之后两者合为一个模型。</translation>
    </message>
    <message>
        <source>After this scan the next position is shown.</source>
        <translation>此次扫描后显示下一位置。</translation>
    </message>
    <message>
        <source>When nothing is left to see, the review opens by itself.</source>
        <translation>没有可看的内容时，检查页会自动打开。</translation>
    </message>
    <message>
        <source>You turn the table as the dial says; after each scan the best next view is shown.</source>
        <translation>由您按刻度盘转动转台；每次扫描后显示下一最佳视图。</translation>
    </message>
    <message>
        <source>Run scans from one position after the other, each chosen by what is still unseen.</source>
        <translation>“运行”从一个位置接一个位置扫描，每个位置都按未见部分选择。</translation>
    </message>
    <message>
        <source>Go on scanning, or look at what there is so far.</source>
        <translation>继续扫描，或查看到目前为止的结果。</translation>
    </message>
    <message>
        <source>The review shows what is covered and what is left.</source>
        <translation>检查页显示已覆盖和剩余的部分。</translation>
    </message>
    <message>
        <source>No scan is lost.</source>
        <translation>不会丢失任何扫描。</translation>
    </message>
    <message>
        <source>Take scans as they &amp;come</source>
        <translation>来一个扫描就采用一个(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Go on</source>
        <translation>继续(&amp;G)</translation>
    </message>
    <message>
        <source>Turn the table as the dial says and scan with the scanner&apos;s own program: whatever it writes is taken, and the next position is shown.</source>
        <translation>请按刻度盘转动转台，并用扫描仪自带的程序扫描：它写出的内容会被采用，然后显示下一位置。</translation>
    </message>
    <message>
        <source>Nothing runs that could pause.</source>
        <translation>没有可暂停的操作。</translation>
    </message>
    <message>
        <source>Nothing runs that could be stopped.</source>
        <translation>没有可停止的操作。</translation>
    </message>
    <message>
        <source>Views in the model</source>
        <translation>模型中的视图</translation>
    </message>
    <message>
        <source>Views in this stand</source>
        <translation>此摆放中的视图</translation>
    </message>
    <message>
        <source>Scans that did not fit</source>
        <translation>未吻合的扫描</translation>
    </message>
    <message>
        <source>kept, but not part of the model</source>
        <translation>已保留，但不属于模型</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>表面</translation>
    </message>
    <message>
        <source>%1 new by the last scan</source>
        <translation>上次扫描新增 %1</translation>
    </message>
    <message>
        <source>Unseen edges</source>
        <translation>未见边</translation>
    </message>
    <message>
        <source>%1 still attract views</source>
        <translation>%1 条仍吸引视图</translation>
    </message>
    <message>
        <source>Acquire</source>
        <translation>采集</translation>
    </message>
    <message>
        <source>&amp;Next: review</source>
        <translation>下一步：检查(&amp;N)</translation>
    </message>
</context>
<context>
    <name>vantage::CalibratePage</name>
    <message>
        <source>&amp;Calibrate</source>
        <translation>标定(&amp;C)</translation>
    </message>
    <message>
        <source>Turn the table step by step, scan at every step, and find its axis from the scans.</source>
        <translation>逐步转动转台，每步扫描一次，并由扫描求出其轴。</translation>
    </message>
    <message>
        <source>S&amp;top</source>
        <translation>停止(&amp;T)</translation>
    </message>
    <message>
        <source>Stop at once; nothing is changed.</source>
        <translation>立即停止；不作任何更改。</translation>
    </message>
    <message>
        <source>&amp;Use this calibration</source>
        <translation>使用此标定(&amp;U)</translation>
    </message>
    <message>
        <source>Write it to a file in the folder of the session, and scan with it.</source>
        <translation>将其写入会话文件夹中的文件，并用于扫描。</translation>
    </message>
    <message>
        <source>Put any object on the table that looks different from every side, not round, and well in sight of the scanner. The table is turned through 60 to 200 degrees.</source>
        <translation>在转台上放置任意一个各面外观不同、非圆形、扫描仪能清楚看到的物体。转台将转过 60 至 200 度。</translation>
    </message>
    <message>
        <source>Number of scans</source>
        <translation>扫描次数</translation>
    </message>
    <message>
        <source>More scans make the axis surer and take longer.</source>
        <translation>扫描越多，轴越准确，但耗时越长。</translation>
    </message>
    <message>
        <source> scans</source>
        <translation> 次扫描</translation>
    </message>
    <message>
        <source>The acquisition page opens. Without a calibration the table is taken to stand and turn as the profile of the scanner says.</source>
        <translation>采集页打开。没有标定时，转台的位置和转动以扫描仪配置文件为准。</translation>
    </message>
    <message>
        <source>In use: %1</source>
        <translation>正在使用：%1</translation>
    </message>
    <message>
        <source>In use: the calibration in the profile.</source>
        <translation>正在使用：配置文件中的标定。</translation>
    </message>
    <message>
        <source>The table is not calibrated.</source>
        <translation>转台未标定。</translation>
    </message>
    <message>
        <source>Nothing runs that could be stopped.</source>
        <translation>没有可停止的操作。</translation>
    </message>
    <message>
        <source>There is nothing that could be used.</source>
        <translation>没有可使用的内容。</translation>
    </message>
    <message>
        <source>Axis, sure to</source>
        <translation>轴的确定度</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>° in its direction</source>
        <translation>°（方向）</translation>
    </message>
    <message>
        <source>Turns, as it counts upwards</source>
        <translation>计数增加时转向</translation>
    </message>
    <message>
        <source>counter-clockwise</source>
        <translation>逆时针</translation>
    </message>
    <message>
        <source>clockwise</source>
        <translation>顺时针</translation>
    </message>
    <message>
        <source>seen from above</source>
        <translation>从上方看</translation>
    </message>
    <message>
        <source>Turned for every degree counted</source>
        <translation>每计一度实际转动</translation>
    </message>
    <message>
        <source>Scan at %1°</source>
        <translation>%1° 处的扫描</translation>
    </message>
    <message>
        <source>off by %1°</source>
        <translation>偏差 %1°</translation>
    </message>
    <message>
        <source>not used</source>
        <translation>未使用</translation>
    </message>
    <message>
        <source>fits to %1 mm</source>
        <translation>吻合到 %1 mm</translation>
    </message>
    <message>
        <source>it shows too little that turns</source>
        <translation>随转台转动的部分太少</translation>
    </message>
    <message>
        <source>Calibrate the table</source>
        <translation>标定转台</translation>
    </message>
    <message>
        <source>&amp;Next: acquire</source>
        <translation>下一步：采集(&amp;N)</translation>
    </message>
</context>
<context>
    <name>vantage::CheckPage</name>
    <message>
        <source>Scanner and object could not be read: %1.</source>
        <translation>无法读取扫描仪和物体：%1。</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>设备</translation>
    </message>
    <message>
        <source>&amp;Fit the object into the volume</source>
        <translation>使物体适配空间(&amp;F)</translation>
    </message>
    <message>
        <source>Scale and centre the object so that it stands inside the viewing volume.</source>
        <translation>缩放并居中物体，使其位于测量空间内。</translation>
    </message>
    <message>
        <source>Make a &amp;test turn</source>
        <translation>试转(&amp;T)</translation>
    </message>
    <message>
        <source>Scan twice, a few positions apart, and compare the turn with the profile. Neither scan is kept.</source>
        <translation>相隔几个位置扫描两次，并将转动与配置文件比较。两次扫描都不保留。</translation>
    </message>
    <message>
        <source>Viewing volume</source>
        <translation>测量空间</translation>
    </message>
    <message>
        <source>What a scan sees</source>
        <translation>扫描所见</translation>
    </message>
    <message>
        <source>Test turn</source>
        <translation>试转</translation>
    </message>
    <message>
        <source>Go back and choose something else. Nothing has been scanned yet.</source>
        <translation>返回并另行选择。尚未扫描任何内容。</translation>
    </message>
    <message>
        <source>Scanner and object are being read.</source>
        <translation>正在读取扫描仪和物体。</translation>
    </message>
    <message>
        <source>Where the table stands before the scanner can be measured, or is taken as it is known.</source>
        <translation>可以测量转台相对扫描仪的位置，或按已知值采用。</translation>
    </message>
    <message>
        <source>The acquisition page opens. Scanning begins when you say so.</source>
        <translation>采集页打开。由您决定何时开始扫描。</translation>
    </message>
    <message>
        <source>&amp;Next: calibrate</source>
        <translation>下一步：标定(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Next: acquire</source>
        <translation>下一步：采集(&amp;N)</translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation>正在读取…</translation>
    </message>
    <message>
        <source>Nothing is chosen yet.</source>
        <translation>尚未选择任何内容。</translation>
    </message>
    <message>
        <source>What stands before the scanner is seen by its first scan.</source>
        <translation>扫描仪前有什么，首次扫描便可看到。</translation>
    </message>
    <message>
        <source>The object reaches out of the viewing volume: what is outside cannot be scanned.</source>
        <translation>物体超出测量空间：外面的部分无法扫描。</translation>
    </message>
    <message>
        <source>The object stands inside the viewing volume.</source>
        <translation>物体位于测量空间内。</translation>
    </message>
    <message>
        <source>Object, radius about the axis</source>
        <translation>物体，绕轴半径</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Object, height</source>
        <translation>物体，高度</translation>
    </message>
    <message>
        <source>Object, lowest point</source>
        <translation>物体，最低点</translation>
    </message>
    <message>
        <source>0 is the table</source>
        <translation>0 为转台面</translation>
    </message>
    <message>
        <source>Positions of the scanner</source>
        <translation>扫描仪位置数</translation>
    </message>
    <message>
        <source>Ranging rays per scan</source>
        <translation>每次扫描的测距射线</translation>
    </message>
    <message>
        <source>A test turn tells whether the table turns about its axis as the profile says.</source>
        <translation>试转可检验转台是否如配置文件所述绕轴转动。</translation>
    </message>
    <message>
        <source>Turn by the profile</source>
        <translation>配置文件中的转角</translation>
    </message>
    <message>
        <source>Turn measured</source>
        <translation>测得的转角</translation>
    </message>
    <message>
        <source>%1° off, up to %2° are as expected</source>
        <translation>偏差 %1°，预期不超过 %2°</translation>
    </message>
    <message>
        <source>Axis moved by</source>
        <translation>轴移动了</translation>
    </message>
    <message>
        <source>up to %1 mm are as expected</source>
        <translation>预期不超过 %1 mm</translation>
    </message>
    <message>
        <source>The scans do not fit: %1</source>
        <translation>扫描不吻合：%1</translation>
    </message>
    <message>
        <source>The scans fit, but the table was turned farther off than is expected of a person: turn it once more.</source>
        <translation>扫描吻合，但转台转动的偏差超出手动转动的预期：请再转一次。</translation>
    </message>
    <message>
        <source>The scans fit, but not where the profile expects the table after its turn: compare the figures, and calibrate the table or mend its profile.</source>
        <translation>扫描吻合，但不在配置文件所预期的转动后位置：请比较数值，标定转台或修正其配置文件。</translation>
    </message>
    <message>
        <source>The scans fit, but hold on to each other too little to measure the turn: %1</source>
        <translation>扫描吻合，但相互约束太少，无法测量转角：%1</translation>
    </message>
    <message>
        <source>The scans fit. The person turned the table by %1° where %2° were asked for, as the scans tell to about %3° and %4 mm. How well the table itself turns, a turn by hand does not tell.</source>
        <translation>扫描吻合。手动将转台转动了 %1°，要求为 %2°；扫描的判断精度约为 %3° 和 %4 mm。手动转动不能说明转台自身转动的精度。</translation>
    </message>
    <message>
        <source>The scans fit. The table turns as expected.</source>
        <translation>扫描吻合。转台转动符合预期。</translation>
    </message>
    <message>
        <source>Check the set-up</source>
        <translation>检查设置</translation>
    </message>
</context>
<context>
    <name>vantage::ChoosePage</name>
    <message>
        <source>None: the scans were recorded elsewhere</source>
        <translation>无：扫描在别处录制</translation>
    </message>
    <message>
        <source>Take another file</source>
        <translation>选择其他文件</translation>
    </message>
    <message>
        <source>Vantage scans an object from positions that it chooses itself, until nothing is left to see.</source>
        <translation>Vantage 从自行选择的位置扫描物体，直到没有可看的为止。</translation>
    </message>
    <message>
        <source>Scanner profile</source>
        <translation>扫描仪配置文件</translation>
    </message>
    <message>
        <source>Profile of the scanner and its turntable.</source>
        <translation>扫描仪及其转台的配置文件。</translation>
    </message>
    <message>
        <source>Scanner profiles (*.json)</source>
        <translation>扫描仪配置文件 (*.json)</translation>
    </message>
    <message>
        <source>Object for the simulated scanner</source>
        <translation>模拟扫描仪的物体</translation>
    </message>
    <message>
        <source>Mesh that the simulated scanner looks at.</source>
        <translation>模拟扫描仪所看的网格。</translation>
    </message>
    <message>
        <source>Meshes (%1);;All files (*)</source>
        <translation>网格 (%1);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Save everything in</source>
        <translation>全部保存到</translation>
    </message>
    <message>
        <source>Folder of the session</source>
        <translation>会话文件夹</translation>
    </message>
    <message>
        <source>Take another folder</source>
        <translation>选择其他文件夹</translation>
    </message>
    <message>
        <source>Options</source>
        <translation>选项</translation>
    </message>
    <message>
        <source>&amp;Open a session…</source>
        <translation>打开会话(&amp;O)…</translation>
    </message>
    <message>
        <source>Go on with a session from a file.</source>
        <translation>从文件继续一个会话。</translation>
    </message>
    <message>
        <source>&amp;Import recorded scans…</source>
        <translation>导入录制的扫描(&amp;I)…</translation>
    </message>
    <message>
        <source>Make a session of range files that were recorded before; they can also be dropped on the window.</source>
        <translation>用以前录制的距离文件建立会话；也可将文件拖放到窗口。</translation>
    </message>
    <message>
        <source>Choose the profile of the scanner first.</source>
        <translation>请先选择扫描仪配置文件。</translation>
    </message>
    <message>
        <source>Choose an object first.</source>
        <translation>请先选择物体。</translation>
    </message>
    <message>
        <source>Choose a folder first.</source>
        <translation>请先选择文件夹。</translation>
    </message>
    <message>
        <source>Options contradict each other.</source>
        <translation>选项相互矛盾。</translation>
    </message>
    <message>
        <source>The set-up of this session is shown. Its scanner and object stay as they are.</source>
        <translation>显示的是此会话的设置。扫描仪和物体保持不变。</translation>
    </message>
    <message>
        <source>Scanner and object are read and checked. Nothing is scanned yet.</source>
        <translation>将读取并检查扫描仪和物体。尚不扫描。</translation>
    </message>
    <message>
        <source>The session that is open keeps what it was begun with.</source>
        <translation>打开的会话保持其开始时的设置。</translation>
    </message>
    <message>
        <source>Scanner and object</source>
        <translation>扫描仪和物体</translation>
    </message>
    <message>
        <source>&amp;Next: check the set-up</source>
        <translation>下一步：检查设置(&amp;N)</translation>
    </message>
    <message>
        <source>The session that is open keeps the object that it was begun with.</source>
        <translation>打开的会话保持其开始时的物体。</translation>
    </message>
    <message>
        <source>Only the simulated scanner looks at a mesh, and another scanner is chosen.</source>
        <translation>只有模拟扫描仪能看网格，而现在选择的是其他扫描仪。</translation>
    </message>
</context>
<context>
    <name>vantage::CompletenessBox</name>
    <message>
        <source>How complete the model is</source>
        <translation>模型的完整程度</translation>
    </message>
    <message>
        <source>Covered of what the scanner reaches</source>
        <translation>扫描仪可及部分的覆盖率</translation>
    </message>
</context>
<context>
    <name>vantage::CrashNotice</name>
    <message>
        <source>Vantage</source>
        <translation>Vantage</translation>
    </message>
    <message>
        <source>Vantage broke when it was last used.</source>
        <translation>Vantage 上次使用时崩溃了。</translation>
    </message>
    <message>
        <source>What it was doing is in %1 in the folder %2. It stays there, and was sent to nobody.</source>
        <translation>当时的情况记录在文件夹 %2 的 %1 中。它留在那里，没有发送给任何人。</translation>
    </message>
    <message>
        <source>The session %1 was open. Every scan was written before anything was made of it.</source>
        <translation>当时打开的会话是 %1。每次扫描都在处理之前已写入。</translation>
    </message>
    <message>
        <source>&amp;Copy the trace</source>
        <translation>复制崩溃记录(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Open the session</source>
        <translation>打开会话(&amp;O)</translation>
    </message>
</context>
<context>
    <name>vantage::CutPictureView</name>
    <message>
        <source>The test scan, with what is cut of it in colours</source>
        <translation>测试扫描，被裁掉的部分以颜色显示</translation>
    </message>
</context>
<context>
    <name>vantage::DeviceBench</name>
    <message>
        <source>Connecting the devices</source>
        <translation>正在连接设备</translation>
    </message>
    <message>
        <source>Turning the table</source>
        <translation>正在转动转台</translation>
    </message>
    <message>
        <source>Setting the reference of the table</source>
        <translation>正在设置转台基准</translation>
    </message>
    <message>
        <source>The devices were given up after a failure. Connect them again.</source>
        <translation>设备因故障已断开。请重新连接。</translation>
    </message>
</context>
<context>
    <name>vantage::DeviceBox</name>
    <message>
        <source>&amp;Connect again</source>
        <translation>重新连接(&amp;C)</translation>
    </message>
    <message>
        <source>Open the devices anew. A turntable then counts from where it stands.</source>
        <translation>重新打开设备。转台随后从当前角度起计数。</translation>
    </message>
    <message>
        <source>Ho&amp;me</source>
        <translation>归零(&amp;M)</translation>
    </message>
    <message>
        <source>Let the table find its index, where it has one, and count from there.</source>
        <translation>让转台寻找其零位标记（如果有），并由此计数。</translation>
    </message>
    <message>
        <source>St&amp;op</source>
        <translation>停止(&amp;O)</translation>
    </message>
    <message>
        <source>Stop the table, and whatever else goes on.</source>
        <translation>停止转台以及其他正在进行的操作。</translation>
    </message>
    <message>
        <source>Turn the table by %1 as it counts.</source>
        <translation>按转台计数转动 %1。</translation>
    </message>
    <message>
        <source>Something else is under way.</source>
        <translation>其他操作正在进行。</translation>
    </message>
    <message>
        <source>The devices are not connected.</source>
        <translation>设备未连接。</translation>
    </message>
    <message>
        <source>ready</source>
        <translation>就绪</translation>
    </message>
    <message>
        <source>not ready</source>
        <translation>未就绪</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>设备</translation>
    </message>
    <message>
        <source>not connected</source>
        <translation>未连接</translation>
    </message>
    <message>
        <source>being connected…</source>
        <translation>正在连接…</translation>
    </message>
    <message>
        <source>&amp;Connect</source>
        <translation>连接(&amp;C)</translation>
    </message>
    <message>
        <source>Nothing runs that could be stopped.</source>
        <translation>没有可停止的操作。</translation>
    </message>
</context>
<context>
    <name>vantage::DeviceEditor</name>
    <message>
        <source>What scans</source>
        <translation>用什么扫描</translation>
    </message>
    <message>
        <source>The range scanner that takes the scans.</source>
        <translation>进行扫描的距离扫描仪。</translation>
    </message>
    <message>
        <source>What turns</source>
        <translation>用什么转动</translation>
    </message>
    <message>
        <source>What brings the object from one position to the next.</source>
        <translation>将物体从一个位置带到下一位置的装置。</translation>
    </message>
    <message>
        <source>Port of the turntable</source>
        <translation>转台端口</translation>
    </message>
    <message>
        <source>The serial port that the turntable is connected to; any path can be typed.</source>
        <translation>转台所连接的串口；可以输入任意路径。</translation>
    </message>
    <message>
        <source>Language of the turntable</source>
        <translation>转台协议</translation>
    </message>
    <message>
        <source>What the controller of the turntable speaks; it is asked when none is chosen.</source>
        <translation>转台控制器使用的协议；未选择时向其查询。</translation>
    </message>
    <message>
        <source>Address of the camera</source>
        <translation>相机地址</translation>
    </message>
    <message>
        <source>The first camera that answers</source>
        <translation>第一个应答的相机</translation>
    </message>
    <message>
        <source>No calibration: the table is where the profile says</source>
        <translation>无标定：转台位置以配置文件为准</translation>
    </message>
    <message>
        <source>Where the table&apos;s axis is, which way and how far it turns, as measured.</source>
        <translation>测得的转台轴位置、转向和转动量。</translation>
    </message>
    <message>
        <source>&amp;Load a rig…</source>
        <translation>加载装置(&amp;L)…</translation>
    </message>
    <message>
        <source>Take scanner, turntable, profile and calibration from a file. Programs as devices are described that way.</source>
        <translation>从文件读取扫描仪、转台、配置文件和标定。作为设备的程序也以此方式描述。</translation>
    </message>
    <message>
        <source>Load a rig</source>
        <translation>加载装置</translation>
    </message>
    <message>
        <source>Rigs (*.json)</source>
        <translation>装置 (*.json)</translation>
    </message>
    <message>
        <source>Simulated scanner</source>
        <translation>模拟扫描仪</translation>
    </message>
    <message>
        <source>Files in a folder</source>
        <translation>文件夹中的文件</translation>
    </message>
    <message>
        <source>Depth camera (OpenNI2)</source>
        <translation>深度相机 (OpenNI2)</translation>
    </message>
    <message>
        <source>Scans of a session again</source>
        <translation>重用会话的扫描</translation>
    </message>
    <message>
        <source>Simulated turntable</source>
        <translation>模拟转台</translation>
    </message>
    <message>
        <source>Turntable on a serial port</source>
        <translation>串口转台</translation>
    </message>
    <message>
        <source>By hand</source>
        <translation>手动</translation>
    </message>
    <message>
        <source>Nothing: a single scan</source>
        <translation>无：单次扫描</translation>
    </message>
    <message>
        <source>Ask the turntable</source>
        <translation>查询转台</translation>
    </message>
    <message>
        <source>Folder that range files are written to</source>
        <translation>写入距离文件的文件夹</translation>
    </message>
    <message>
        <source>Session</source>
        <translation>会话</translation>
    </message>
    <message>
        <source>Sessions (*.vantage)</source>
        <translation>会话 (*.vantage)</translation>
    </message>
    <message>
        <source>Calibration of the table</source>
        <translation>转台标定</translation>
    </message>
    <message>
        <source>Calibrations (*.json)</source>
        <translation>标定 (*.json)</translation>
    </message>
    <message>
        <source>Take another file</source>
        <translation>选择其他文件</translation>
    </message>
    <message>
        <source>No port is there: connect the table, or type its path</source>
        <translation>没有端口：请连接转台，或输入其路径</translation>
    </message>
    <message>
        <source>Choose the folder that the scanner&apos;s program writes to.</source>
        <translation>请选择扫描仪程序写入的文件夹。</translation>
    </message>
    <message>
        <source>Choose the session whose scans are taken again.</source>
        <translation>请选择要重用其扫描的会话。</translation>
    </message>
    <message>
        <source>The simulated scanner sees the simulated table only.</source>
        <translation>模拟扫描仪只能看到模拟转台。</translation>
    </message>
    <message>
        <source>A real scanner does not see the simulated table.</source>
        <translation>真实扫描仪看不到模拟转台。</translation>
    </message>
    <message>
        <source>Choose the port of the turntable.</source>
        <translation>请选择转台端口。</translation>
    </message>
    <message>
        <source>You turn the table as the dial says, about as far as asked: where it really came to stand is found from the scan.</source>
        <translation>由您按刻度盘将转台转到大致所需的角度：其实际位置由扫描得出。</translation>
    </message>
</context>
<context>
    <name>vantage::DiagnosticsDialog</name>
    <message>
        <source>With the names of &amp;files and folders</source>
        <translation>包含文件和文件夹名称(&amp;F)</translation>
    </message>
    <message>
        <source>Diagnostics</source>
        <translation>诊断</translation>
    </message>
    <message>
        <source>For somebody who is to help. It is sent to nobody: copy it to where it is wanted.</source>
        <translation>供协助者使用。不会发送给任何人：请复制到需要之处。</translation>
    </message>
    <message>
        <source>Without them every name of a file is replaced by &lt;file&gt;.</source>
        <translation>不包含时，每个文件名都替换为 &lt;file&gt;。</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>复制(&amp;C)</translation>
    </message>
    <message>
        <source>Put the text into the clipboard.</source>
        <translation>将文本放入剪贴板。</translation>
    </message>
</context>
<context>
    <name>vantage::EraseBar</name>
    <message>
        <source>How far above the table</source>
        <translation>高出转台多少</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>How large a piece may be</source>
        <translation>部分最大多大</translation>
    </message>
    <message>
        <source> mm²</source>
        <translation> mm²</translation>
    </message>
    <message>
        <source>Only the near side</source>
        <translation>仅近侧</translation>
    </message>
    <message>
        <source>Lasso</source>
        <translation>套索</translation>
    </message>
    <message>
        <source>Draw around it, in any shape</source>
        <translation>以任意形状圈出</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>矩形</translation>
    </message>
    <message>
        <source>Draw a rectangle around it</source>
        <translation>画矩形框出</translation>
    </message>
    <message>
        <source>Below a plane</source>
        <translation>平面以下</translation>
    </message>
    <message>
        <source>All that lies lower than a height above the table</source>
        <translation>低于转台上方某一高度的所有部分</translation>
    </message>
    <message>
        <source>Loose pieces</source>
        <translation>零散部分</translation>
    </message>
    <message>
        <source>Pieces that hang together with nothing else; the largest one stays</source>
        <translation>与其他部分不相连的部分；保留最大的一个</translation>
    </message>
    <message>
        <source>What lies behind it, after a gap, stays</source>
        <translation>隔开一段距离、位于其后的部分保留</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>擦除</translation>
    </message>
    <message>
        <source>Erase what is marked; Undo takes it back</source>
        <translation>擦除标出的部分；可用“撤销”恢复</translation>
    </message>
    <message>
        <source>Done (Esc)</source>
        <translation>完成 (Esc)</translation>
    </message>
    <message>
        <source>Erase nothing more</source>
        <translation>不再擦除</translation>
    </message>
    <message>
        <source>Draw around what is not the object with the left button held. By keys: arrows, space for a corner, Enter.</source>
        <translation>按住左键圈出非物体的部分。用键盘：方向键移动，空格键定角点，Enter 键结束。</translation>
    </message>
    <message>
        <source>Draw a rectangle around what is not the object with the left button held. By keys: arrows, space, arrows, Enter.</source>
        <translation>按住左键画矩形框出非物体的部分。用键盘：方向键，空格键，方向键，Enter 键。</translation>
    </message>
    <message>
        <source>Looking for it…</source>
        <translation>正在查找…</translation>
    </message>
    <message>
        <source>The model has no loose piece of that size.</source>
        <translation>模型没有这样大小的零散部分。</translation>
    </message>
    <message>
        <source>Nothing of the model lies there.</source>
        <translation>该处没有模型的任何部分。</translation>
    </message>
    <message>
        <source>The marked piece would go, %1.</source>
        <translation>将擦除标出的部分，%1。</translation>
    </message>
    <message>
        <source>The %1 marked pieces would go, %2 together.</source>
        <translation>将擦除标出的 %1 个部分，共 %2。</translation>
    </message>
    <message>
        <source>Nothing is marked that could be erased.</source>
        <translation>没有标出可擦除的部分。</translation>
    </message>
</context>
<context>
    <name>vantage::EraseDesk</name>
    <message>
        <source>An earlier moment is shown: go back to now first.</source>
        <translation>显示的是较早的时刻：请先返回当前。</translation>
    </message>
</context>
<context>
    <name>vantage::FinishPage</name>
    <message>
        <source>Export the model</source>
        <translation>导出模型</translation>
    </message>
    <message>
        <source>Export ST&amp;L</source>
        <translation>导出 STL(&amp;L)</translation>
    </message>
    <message>
        <source>Triangles only, for printing and CAD.</source>
        <translation>仅三角形，用于打印和 CAD。</translation>
    </message>
    <message>
        <source>Export &amp;PLY</source>
        <translation>导出 PLY(&amp;P)</translation>
    </message>
    <message>
        <source>With a confidence per vertex and a view per face.</source>
        <translation>每个顶点含置信度，每个面含视图。</translation>
    </message>
    <message>
        <source>Export &amp;OBJ</source>
        <translation>导出 OBJ(&amp;O)</translation>
    </message>
    <message>
        <source>Text that nearly every program reads.</source>
        <translation>几乎所有程序都能读取的文本。</translation>
    </message>
    <message>
        <source>Export &amp;as…</source>
        <translation>导出为(&amp;A)…</translation>
    </message>
    <message>
        <source>To a file of your choice.</source>
        <translation>导出到您选择的文件。</translation>
    </message>
    <message>
        <source>STL (*.stl);;PLY (*.ply);;OBJ (*.obj);;3MF (*.3mf)</source>
        <translation>STL (*.stl);;PLY (*.ply);;OBJ (*.obj);;3MF (*.3mf)</translation>
    </message>
    <message>
        <source>Rea&amp;dy to print…</source>
        <translation>打印准备(&amp;D)…</translation>
    </message>
    <message>
        <source>Closed, in one piece, or you learn why not; also fewer triangles, inches, 3MF.</source>
        <translation>封闭且为一体，否则说明原因；还可减少三角形、使用英寸、3MF。</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>报告</translation>
    </message>
    <message>
        <source>&amp;Write the report</source>
        <translation>写报告(&amp;W)</translation>
    </message>
    <message>
        <source>One HTML page with pictures, figures, times and what is left.</source>
        <translation>一个 HTML 页面，含图片、数值、时间和剩余部分。</translation>
    </message>
    <message>
        <source>Written: %1 (&lt;a href=&quot;%2&quot;&gt;open&lt;/a&gt;, &lt;a href=&quot;%3&quot;&gt;show the folder&lt;/a&gt;)</source>
        <translation>已写入：%1（&lt;a href=&quot;%2&quot;&gt;打开&lt;/a&gt;，&lt;a href=&quot;%3&quot;&gt;显示文件夹&lt;/a&gt;）</translation>
    </message>
    <message>
        <source>Not written: the model cannot be printed as one piece.</source>
        <translation>未写入：模型无法作为一体打印。</translation>
    </message>
    <message>
        <source>Vantage</source>
        <translation>Vantage</translation>
    </message>
    <message>
        <source>%1 is there already.</source>
        <translation>%1 已存在。</translation>
    </message>
    <message>
        <source>In %1. If you replace it, what it holds now is gone.</source>
        <translation>位于 %1。如果替换，现有内容将丢失。</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>替换(&amp;R)</translation>
    </message>
    <message>
        <source>Export for printing</source>
        <translation>导出用于打印</translation>
    </message>
    <message>
        <source>3MF (*.3mf);;STL (*.stl);;PLY (*.ply);;OBJ (*.obj)</source>
        <translation>3MF (*.3mf);;STL (*.stl);;PLY (*.ply);;OBJ (*.obj)</translation>
    </message>
    <message>
        <source>This session stays on the disk as it is. A new one begins with scanner and object.</source>
        <translation>此会话原样保留在磁盘上。新会话从扫描仪和物体开始。</translation>
    </message>
    <message>
        <source>Into %1</source>
        <translation>%1（写入位置）</translation>
    </message>
    <message>
        <source>An earlier moment is shown; written is the session as it is now.</source>
        <translation>显示的是较早的时刻；写入的是会话当前的状态。</translation>
    </message>
    <message>
        <source>The scans have colours: PLY and OBJ keep them, STL and 3MF do not.</source>
        <translation>扫描带有颜色：PLY 和 OBJ 会保留，STL 和 3MF 不保留。</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>完成</translation>
    </message>
    <message>
        <source>&amp;New session</source>
        <translation>新会话(&amp;N)</translation>
    </message>
</context>
<context>
    <name>vantage::HelpDesk</name>
    <message>
        <source>&amp;Manual</source>
        <translation>手册(&amp;M)</translation>
    </message>
    <message>
        <source>M&amp;essages and what to do</source>
        <translation>消息与处理办法(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Keyboard</source>
        <translation>键盘(&amp;K)</translation>
    </message>
    <message>
        <source>&amp;Words</source>
        <translation>术语(&amp;W)</translation>
    </message>
</context>
<context>
    <name>vantage::HelpWindow</name>
    <message>
        <source>Manual – Vantage</source>
        <translation>手册 – Vantage</translation>
    </message>
    <message>
        <source>The manual is not there: %1 cannot be read. On Debian it comes with the package vantage-data.</source>
        <translation>手册不存在：无法读取 %1。在 Debian 上它随软件包 vantage-data 一起安装。</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>上一步(&amp;B)</translation>
    </message>
    <message>
        <source>The page before (Alt+Left).</source>
        <translation>上一页（Alt+左）。</translation>
    </message>
    <message>
        <source>&amp;Forward</source>
        <translation>前进(&amp;F)</translation>
    </message>
    <message>
        <source>The page after (Alt+Right).</source>
        <translation>下一页（Alt+右）。</translation>
    </message>
    <message>
        <source>&amp;Contents</source>
        <translation>目录(&amp;C)</translation>
    </message>
    <message>
        <source>All chapters (Alt+Home).</source>
        <translation>所有章节（Alt+Home）。</translation>
    </message>
    <message>
        <source>No page was shown before.</source>
        <translation>之前没有显示过页面。</translation>
    </message>
    <message>
        <source>No page comes after.</source>
        <translation>后面没有页面了。</translation>
    </message>
    <message>
        <source>Search all pages (Ctrl+F)</source>
        <translation>搜索所有页面（Ctrl+F）</translation>
    </message>
    <message>
        <source>Words to search for in all pages</source>
        <translation>要在所有页面中搜索的词</translation>
    </message>
    <message>
        <source>Chapters, or what was found</source>
        <translation>章节，或搜索结果</translation>
    </message>
    <message>
        <source>No section of the manual has these words.</source>
        <translation>手册中没有包含这些词的章节。</translation>
    </message>
</context>
<context>
    <name>vantage::ImportDialog</name>
    <message>
        <source>Scanner</source>
        <translation>扫描仪</translation>
    </message>
    <message>
        <source>Scans of a known scanner lie on its rays; of others the rays are found from the files.</source>
        <translation>已知扫描仪的扫描位于其射线上；其他扫描的射线由文件得出。</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>What the command line calls --unit.</source>
        <translation>对应命令行的 --unit。</translation>
    </message>
    <message>
        <source>Where the scanner looks</source>
        <translation>扫描仪朝向</translation>
    </message>
    <message>
        <source>In the coordinates of the files; what the command line calls --frame.</source>
        <translation>采用文件坐标；对应命令行的 --frame。</translation>
    </message>
    <message>
        <source>Rows and columns</source>
        <translation>行和列</translation>
    </message>
    <message>
        <source>Of points as text, one line for every cell; what the command line calls --grid.</source>
        <translation>用于文本格式的点，每个单元一行；对应命令行的 --grid。</translation>
    </message>
    <message>
        <source>As the files say, for instance 480x640</source>
        <translation>按文件，例如 480x640</translation>
    </message>
    <message>
        <source>Where nothing was measured</source>
        <translation>未测量之处</translation>
    </message>
    <message>
        <source>The value that stands where nothing was measured; what the command line calls --no-sample.</source>
        <translation>未测量处的值；对应命令行的 --no-sample。</translation>
    </message>
    <message>
        <source>As it is found, for instance 0 or -9999</source>
        <translation>自动判断，例如 0 或 -9999</translation>
    </message>
    <message>
        <source>Import recorded scans</source>
        <translation>导入录制的扫描</translation>
    </message>
    <message>
        <source>Add scans to the session</source>
        <translation>向会话添加扫描</translation>
    </message>
    <message>
        <source>Scans of one scanner, of one object. They are registered and merged; where they were taken from is found, or said here.</source>
        <translation>同一扫描仪对同一物体的扫描。它们将被配准并合并；采集位置自动求出或在此指定。</translation>
    </message>
    <message>
        <source>Each scan is registered at the position that it was taken from, one after the other.</source>
        <translation>每个扫描依次在其采集位置处配准。</translation>
    </message>
    <message>
        <source>Taken with</source>
        <translation>采集设备</translation>
    </message>
    <message>
        <source>List of poses</source>
        <translation>位姿列表</translation>
    </message>
    <message>
        <source>None: as the files say, or found</source>
        <translation>无：按文件或自动求出</translation>
    </message>
    <message>
        <source>Take a file</source>
        <translation>选择文件</translation>
    </message>
    <message>
        <source>List of poses (.conf)</source>
        <translation>位姿列表 (.conf)</translation>
    </message>
    <message>
        <source>as it is found</source>
        <translation>自动判断</translation>
    </message>
    <message>
        <source>Unit (--unit)</source>
        <translation>单位 (--unit)</translation>
    </message>
    <message>
        <source>The scanner looks (--frame)</source>
        <translation>扫描仪朝向 (--frame)</translation>
    </message>
    <message>
        <source>Rows × columns (--grid)</source>
        <translation>行 × 列 (--grid)</translation>
    </message>
    <message>
        <source>No sample is (--no-sample)</source>
        <translation>无采样值 (--no-sample)</translation>
    </message>
    <message>
        <source>Folder of the session</source>
        <translation>会话文件夹</translation>
    </message>
    <message>
        <source>Save everything in</source>
        <translation>全部保存到</translation>
    </message>
    <message>
        <source>&amp;Import</source>
        <translation>导入(&amp;I)</translation>
    </message>
    <message>
        <source>&amp;Add</source>
        <translation>添加(&amp;A)</translation>
    </message>
    <message>
        <source>a scanner without a profile: its rays are found from the files</source>
        <translation>无配置文件的扫描仪：其射线由文件得出</translation>
    </message>
    <message>
        <source>the scanner of %1</source>
        <translation>%1 的扫描仪</translation>
    </message>
    <message>
        <source>Poses (*.conf)</source>
        <translation>位姿 (*.conf)</translation>
    </message>
    <message>
        <source>Something else is under way.</source>
        <translation>其他操作正在进行。</translation>
    </message>
    <message>
        <source>Add the range files first.</source>
        <translation>请先添加距离文件。</translation>
    </message>
    <message>
        <source>Say of every file from which position it was taken.</source>
        <translation>请说明每个文件的采集位置。</translation>
    </message>
    <message>
        <source>Positions and a list of poses both say where the scans were taken: give one.</source>
        <translation>位置和位姿列表都说明采集处：请只给出一种。</translation>
    </message>
    <message>
        <source>Rows and columns are two numbers from 2 on, for instance 480x640.</source>
        <translation>行和列是两个不小于 2 的数，例如 480x640。</translation>
    </message>
    <message>
        <source>The value where nothing was measured is a number.</source>
        <translation>未测量处的值是一个数。</translation>
    </message>
    <message>
        <source>Choose a folder first.</source>
        <translation>请先选择文件夹。</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
</context>
<context>
    <name>vantage::JobPanel</name>
    <message>
        <source>Progress</source>
        <translation>进度</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Cancel what is being computed</source>
        <translation>取消正在进行的计算</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>就绪</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1；%2</translation>
    </message>
</context>
<context>
    <name>vantage::JobRunner</name>
    <message>
        <source>There is not enough memory for this.</source>
        <translation>内存不足。</translation>
    </message>
</context>
<context>
    <name>vantage::LogPanel</name>
    <message>
        <source>Log</source>
        <translation>日志</translation>
    </message>
    <message>
        <source>Nothing has happened yet.</source>
        <translation>尚未发生任何事。</translation>
    </message>
    <message>
        <source>Problem: %1</source>
        <translation>问题：%1</translation>
    </message>
</context>
<context>
    <name>vantage::MainWindow</name>
    <message>
        <source>Session</source>
        <translation>会话</translation>
    </message>
    <message>
        <source>Objective</source>
        <translation>目标函数</translation>
    </message>
    <message>
        <source>Ctrl+2</source>
        <translation>Ctrl+2</translation>
    </message>
    <message>
        <source>Positional space</source>
        <translation>位置空间</translation>
    </message>
    <message>
        <source>Ctrl+3</source>
        <translation>Ctrl+3</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>展开图</translation>
    </message>
    <message>
        <source>Ctrl+4</source>
        <translation>Ctrl+4</translation>
    </message>
    <message>
        <source>Why this view</source>
        <translation>为何选此视图</translation>
    </message>
    <message>
        <source>Ctrl+5</source>
        <translation>Ctrl+5</translation>
    </message>
    <message>
        <source>Time line</source>
        <translation>时间线</translation>
    </message>
    <message>
        <source>Ctrl+6</source>
        <translation>Ctrl+6</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>日志</translation>
    </message>
    <message>
        <source>Ctrl+7</source>
        <translation>Ctrl+7</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>编辑(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>撤销(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>重做(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Settings…</source>
        <translation>设置(&amp;S)…</translation>
    </message>
    <message>
        <source>Ctrl+,</source>
        <translation>Ctrl+,</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>帮助(&amp;H)</translation>
    </message>
    <message>
        <source>Copy &amp;diagnostics…</source>
        <translation>复制诊断信息(&amp;D)…</translation>
    </message>
    <message>
        <source>&amp;About Vantage</source>
        <translation>关于 Vantage(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Session</source>
        <translation>会话(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>打开(&amp;O)…</translation>
    </message>
    <message>
        <source>Open to &amp;look at…</source>
        <translation>打开以查看(&amp;L)…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+O</source>
        <translation>Ctrl+Shift+O</translation>
    </message>
    <message>
        <source>&amp;Import or add scans…</source>
        <translation>导入或添加扫描(&amp;I)…</translation>
    </message>
    <message>
        <source>Ctrl+I</source>
        <translation>Ctrl+I</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>关闭(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Run or go on</source>
        <translation>运行或继续(&amp;R)</translation>
    </message>
    <message>
        <source>F5</source>
        <translation>F5</translation>
    </message>
    <message>
        <source>One &amp;scan</source>
        <translation>单次扫描(&amp;S)</translation>
    </message>
    <message>
        <source>F6</source>
        <translation>F6</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>暂停(&amp;P)</translation>
    </message>
    <message>
        <source>F7</source>
        <translation>F7</translation>
    </message>
    <message>
        <source>S&amp;top (also Esc)</source>
        <translation>停止（也可按 Esc）(&amp;T)</translation>
    </message>
    <message>
        <source>Shift+F5</source>
        <translation>Shift+F5</translation>
    </message>
    <message>
        <source>T&amp;urn the object over…</source>
        <translation>翻转物体(&amp;U)…</translation>
    </message>
    <message>
        <source>Ctrl+T</source>
        <translation>Ctrl+T</translation>
    </message>
    <message>
        <source>How the stan&amp;ds lie in each other…</source>
        <translation>各摆放的相互位置(&amp;D)…</translation>
    </message>
    <message>
        <source>Ctrl+D</source>
        <translation>Ctrl+D</translation>
    </message>
    <message>
        <source>Next pa&amp;ge</source>
        <translation>下一页(&amp;G)</translation>
    </message>
    <message>
        <source>Alt+Right</source>
        <translation>Alt+Right</translation>
    </message>
    <message>
        <source>Page &amp;before</source>
        <translation>上一页(&amp;B)</translation>
    </message>
    <message>
        <source>Alt+Left</source>
        <translation>Alt+Left</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>退出(&amp;Q)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>视图(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>适合窗口(&amp;F)</translation>
    </message>
    <message>
        <source>Fr&amp;ont</source>
        <translation>前视(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>俯视(&amp;T)</translation>
    </message>
    <message>
        <source>Scanner&apos;s &amp;eye</source>
        <translation>扫描仪视角(&amp;E)</translation>
    </message>
    <message>
        <source>Ob&amp;lique</source>
        <translation>斜视(&amp;L)</translation>
    </message>
    <message>
        <source>Fit with the ta&amp;ble</source>
        <translation>连同转台适合窗口(&amp;B)</translation>
    </message>
    <message>
        <source>Objective as bars o&amp;r dial</source>
        <translation>目标函数：条形或刻度盘(&amp;R)</translation>
    </message>
    <message>
        <source>Ctrl+B</source>
        <translation>Ctrl+B</translation>
    </message>
    <message>
        <source>&amp;Now</source>
        <translation>当前(&amp;N)</translation>
    </message>
    <message>
        <source>Ctrl+End</source>
        <translation>Ctrl+End</translation>
    </message>
    <message>
        <source>To the &amp;page</source>
        <translation>转到页面(&amp;P)</translation>
    </message>
    <message>
        <source>Ctrl+1</source>
        <translation>Ctrl+1</translation>
    </message>
    <message>
        <source>&amp;Usual layout</source>
        <translation>默认布局(&amp;U)</translation>
    </message>
    <message>
        <source>The session is damaged: %1 things in it could not be read. What is whole is shown.</source>
        <translation>会话已损坏：其中 %1 项无法读取。显示的是完好的部分。</translation>
    </message>
    <message>
        <source>Nothing runs that could pause.</source>
        <translation>没有可暂停的操作。</translation>
    </message>
    <message>
        <source>Nothing runs that could be stopped.</source>
        <translation>没有可停止的操作。</translation>
    </message>
    <message>
        <source>Vantage</source>
        <translation>Vantage</translation>
    </message>
    <message>
        <source>%1 (to be looked at only) – Vantage</source>
        <translation>%1（仅供查看）– Vantage</translation>
    </message>
    <message>
        <source>%1 – Vantage</source>
        <translation>%1 – Vantage</translation>
    </message>
    <message>
        <source>The model</source>
        <translation>模型</translation>
    </message>
    <message>
        <source>From the front</source>
        <translation>从前方</translation>
    </message>
    <message>
        <source>From above</source>
        <translation>从上方</translation>
    </message>
    <message>
        <source>About Vantage</source>
        <translation>关于 Vantage</translation>
    </message>
    <message>
        <source>Vantage %1

A scanning workstation that decides where to scan next, after R. Pito, &quot;A Solution to the Next Best View Problem for Automated Surface Acquisition&quot;, 1999.

Apache License 2.0. Made with Qt, VTK, Embree, Eigen, OpenMesh, assimp and SQLite.</source>
        <translation>Vantage %1

能决定下一步从何处扫描的扫描工作站，依据 R. Pito，“A Solution to the Next Best View Problem for Automated Surface Acquisition”，1999。

Apache 许可证 2.0。使用 Qt、VTK、Embree、Eigen、OpenMesh、assimp 和 SQLite 构建。</translation>
    </message>
    <message>
        <source>&amp;Erase from the model…</source>
        <translation>从模型中擦除(&amp;E)…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+E</source>
        <translation>Ctrl+Shift+E</translation>
    </message>
    <message>
        <source>Ne&amp;w session</source>
        <translation>新会话(&amp;W)</translation>
    </message>
    <message>
        <source>Recentl&amp;y opened</source>
        <translation>最近打开(&amp;Y)</translation>
    </message>
    <message>
        <source>E&amp;xport the model…</source>
        <translation>导出模型(&amp;X)…</translation>
    </message>
    <message>
        <source>Ctrl+E</source>
        <translation>Ctrl+E</translation>
    </message>
    <message>
        <source>Write t&amp;he report</source>
        <translation>写报告(&amp;H)</translation>
    </message>
    <message>
        <source>Ctrl+R</source>
        <translation>Ctrl+R</translation>
    </message>
    <message>
        <source>How the model is &amp;drawn</source>
        <translation>模型的显示方式(&amp;D)</translation>
    </message>
</context>
<context>
    <name>vantage::ManualBrowser</name>
    <message>
        <source>Page of the manual</source>
        <translation>手册页面</translation>
    </message>
</context>
<context>
    <name>vantage::ModelPane</name>
    <message>
        <source>Colour of the surface</source>
        <translation>表面颜色</translation>
    </message>
    <message>
        <source>Plain</source>
        <translation>单色</translation>
    </message>
    <message>
        <source>Confidence</source>
        <translation>置信度</translation>
    </message>
    <message>
        <source>View</source>
        <translation>视图</translation>
    </message>
    <message>
        <source>Age</source>
        <translation>先后</translation>
    </message>
    <message>
        <source>Colour of the unseen edges</source>
        <translation>未见边的颜色</translation>
    </message>
    <message>
        <source>Edges by kind</source>
        <translation>边（按类型）</translation>
    </message>
    <message>
        <source>Edges by state</source>
        <translation>边（按状态）</translation>
    </message>
    <message>
        <source>Unseen</source>
        <translation>未见</translation>
    </message>
    <message>
        <source>Unseen edges: where the model ends and the unseen begins (void patches)</source>
        <translation>未见边：模型结束、未见部分开始之处（未知面片）</translation>
    </message>
    <message>
        <source>Last rays</source>
        <translation>上次射线</translation>
    </message>
    <message>
        <source>Rays of the last view</source>
        <translation>上一视图的射线</translation>
    </message>
    <message>
        <source>Next rays</source>
        <translation>下次射线</translation>
    </message>
    <message>
        <source>Rays of the proposed view, or of the position asked about</source>
        <translation>建议视图或所查询位置的射线</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>转台</translation>
    </message>
    <message>
        <source>Turntable with its scale</source>
        <translation>带刻度的转台</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>颜色</translation>
    </message>
    <message>
        <source>Stand</source>
        <translation>摆放</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>相机</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>适合</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>前</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>上</translation>
    </message>
    <message>
        <source>Scanner&apos;s eye</source>
        <translation>扫描仪视角</translation>
    </message>
    <message>
        <source>Oblique</source>
        <translation>斜</translation>
    </message>
    <message>
        <source>Erase…</source>
        <translation>擦除…</translation>
    </message>
    <message>
        <source>Erase what is not the object: putty, a clamp, the table, loose pieces</source>
        <translation>擦除非物体的部分：油泥、夹具、转台、零散部分</translation>
    </message>
</context>
<context>
    <name>vantage::ModelView</name>
    <message>
        <source>Model</source>
        <translation>模型</translation>
    </message>
    <message>
        <source>The model cannot be shown: %1</source>
        <translation>无法显示模型：%1</translation>
    </message>
    <message>
        <source>The cut cannot be computed: %1</source>
        <translation>无法计算剖切：%1</translation>
    </message>
</context>
<context>
    <name>vantage::NextViewBox</name>
    <message>
        <source>Next view</source>
        <translation>下一视图</translation>
    </message>
    <message>
        <source>T&amp;ake it</source>
        <translation>采用(&amp;A)</translation>
    </message>
    <message>
        <source>Scan from this position next.</source>
        <translation>下一次从此位置扫描。</translation>
    </message>
    <message>
        <source>Proposa&amp;l</source>
        <translation>建议(&amp;L)</translation>
    </message>
    <message>
        <source>Go back to the proposed position.</source>
        <translation>返回建议的位置。</translation>
    </message>
    <message>
        <source>Another position</source>
        <translation>其他位置</translation>
    </message>
    <message>
        <source>Other:</source>
        <translation>其他：</translation>
    </message>
    <message>
        <source>Put the scanner at position %1.</source>
        <translation>请将扫描仪放到位置 %1。</translation>
    </message>
    <message>
        <source>Leave the table as it stands.</source>
        <translation>转台保持不动。</translation>
    </message>
    <message>
        <source>Turn the table %1 counter-clockwise, seen from above.</source>
        <translation>请将转台逆时针转动 %1（从上方看）。</translation>
    </message>
    <message>
        <source>Turn the table %1 clockwise, seen from above.</source>
        <translation>请将转台顺时针转动 %1（从上方看）。</translation>
    </message>
    <message>
        <source> Then the scanner looks at the mark %1° of the table.</source>
        <translation>此时扫描仪正对转台的 %1° 刻度。</translation>
    </message>
    <message>
        <source> Raise the scanner by %1.</source>
        <translation>将扫描仪抬高 %1。</translation>
    </message>
    <message>
        <source> Lower the scanner by %1.</source>
        <translation>将扫描仪降低 %1。</translation>
    </message>
    <message>
        <source>Recorded scans have no next view.</source>
        <translation>录制的扫描没有下一视图。</translation>
    </message>
    <message>
        <source>No further view is proposed.</source>
        <translation>不再建议其他视图。</translation>
    </message>
    <message>
        <source>Position %1</source>
        <translation>位置 %1</translation>
    </message>
    <message>
        <source>If you go on: position %1 shows %2</source>
        <translation>如果继续：位置 %1 显示 %2</translation>
    </message>
    <message>
        <source>Position %1, your choice: shows %2</source>
        <translation>位置 %1（您的选择）：显示 %2</translation>
    </message>
    <message>
        <source>Position %1, proposed: shows %2</source>
        <translation>位置 %1（建议）：显示 %2</translation>
    </message>
    <message>
        <source>No other position was taken.</source>
        <translation>没有采用其他位置。</translation>
    </message>
    <message>
        <source>An earlier moment is shown; a choice holds for now.</source>
        <translation>显示的是较早的时刻；选择对当前有效。</translation>
    </message>
    <message>
        <source>After the first scan every position is compared here.</source>
        <translation>首次扫描后在此比较每个位置。</translation>
    </message>
    <message>
        <source>The next scan is taken from here. </source>
        <translation>下一次扫描由此进行。</translation>
    </message>
    <message>
        <source>It would show %1.</source>
        <translation>可显示 %1。</translation>
    </message>
    <message>
        <source>This is the proposed position.</source>
        <translation>这是建议的位置。</translation>
    </message>
    <message>
        <source>Shows %1 less than the proposal</source>
        <translation>比建议的位置少显示 %1</translation>
    </message>
    <message>
        <source>Shows %1 more than the proposal</source>
        <translation>比建议的位置多显示 %1</translation>
    </message>
    <message>
        <source>, and its overlap is %1 short: registration may fail</source>
        <translation>，且重叠少 %1：配准可能失败</translation>
    </message>
    <message>
        <source>, and it overlaps the model too little: registration would fail</source>
        <translation>，且与模型重叠太少：配准会失败</translation>
    </message>
    <message>
        <source>, and its registration would be uncertain</source>
        <translation>，且其配准不确定</translation>
    </message>
</context>
<context>
    <name>vantage::ObjectiveView</name>
    <message>
        <source>Objective of every position</source>
        <translation>每个位置的目标函数</translation>
    </message>
</context>
<context>
    <name>vantage::OtherTurnBox</name>
    <message>
        <source>Scan %1 fits another turn of the table than was said. If the table stood there:</source>
        <translation>扫描 %1 与所述不同的转台角度吻合。如果转台当时位于该处：</translation>
    </message>
    <message>
        <source>It was taken at %1</source>
        <translation>它采集于 %1</translation>
    </message>
    <message>
        <source>Take the scan as one with the table at %1, counter-clockwise from its first position, seen from above: there it fits.</source>
        <translation>将该扫描视为转台位于 %1（从首个位置逆时针计，从上方看）时采集：在该处吻合。</translation>
    </message>
</context>
<context>
    <name>vantage::PointPicker</name>
    <message>
        <source>Object, to pick points on</source>
        <translation>物体，用于选点</translation>
    </message>
    <message>
        <source>Stand, to pick points on</source>
        <translation>摆放，用于选点</translation>
    </message>
    <message>
        <source>&amp;Remove last</source>
        <translation>删除最后一个(&amp;R)</translation>
    </message>
    <message>
        <source>Takes back the point or pair that was picked last (Backspace).</source>
        <translation>撤回最后选取的点或点对（退格键）。</translation>
    </message>
    <message>
        <source>&amp;Align from the points</source>
        <translation>按点对齐(&amp;A)</translation>
    </message>
    <message>
        <source>The points are where the alignment begins. What it finds is checked as always.</source>
        <translation>对齐从这些点开始。结果照常检验。</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>物体</translation>
    </message>
    <message>
        <source>Stand</source>
        <translation>摆放</translation>
    </message>
    <message>
        <source>Click place %1 on the object.</source>
        <translation>请点击物体上的第 %1 处。</translation>
    </message>
    <message>
        <source>Click place %1 on the stand.</source>
        <translation>请点击摆放上的第 %1 处。</translation>
    </message>
    <message>
        <source>Click place %1 on the object, then the same place on the stand. Three places or more are needed, far from each other.</source>
        <translation>请点击物体上的第 %1 处，再点击摆放上的同一处。需要三处以上，且相距较远。</translation>
    </message>
    <message>
        <source>%1 places are picked. Align from them, or click further ones.</source>
        <translation>已选取 %1 处。请据此对齐，或继续点击。</translation>
    </message>
    <message>
        <source>No point was picked yet.</source>
        <translation>尚未选取任何点。</translation>
    </message>
    <message>
        <source>Three places on both are needed, %1 are picked.</source>
        <translation>两者上各需三处，已选取 %1 处。</translation>
    </message>
</context>
<context>
    <name>vantage::PoseChooser</name>
    <message>
        <source>Object and stand over each other</source>
        <translation>物体与摆放叠放</translation>
    </message>
    <message>
        <source>&amp;Use this one</source>
        <translation>使用此位姿(&amp;U)</translation>
    </message>
    <message>
        <source>The stand becomes part of the model in this pose. It can be undone.</source>
        <translation>摆放以此位姿成为模型的一部分。可以撤销。</translation>
    </message>
    <message>
        <source>Poses that were found</source>
        <translation>找到的位姿</translation>
    </message>
    <message>
        <source>, in use</source>
        <translation>，正在使用</translation>
    </message>
    <message>
        <source>As each of them stands on the table</source>
        <translation>各位姿在转台上的样子</translation>
    </message>
    <message>
        <source>&amp;Use it all the same</source>
        <translation>仍然使用(&amp;U)</translation>
    </message>
    <message>
        <source>The stand becomes part of the model although something speaks against this pose. The report says so. It can be undone.</source>
        <translation>尽管此位姿有不利证据，摆放仍成为模型的一部分。报告会说明。可以撤销。</translation>
    </message>
    <message>
        <source>No pose was found yet.</source>
        <translation>尚未找到位姿。</translation>
    </message>
</context>
<context>
    <name>vantage::PositionalPane</name>
    <message>
        <source>Straight out</source>
        <translation>正前方</translation>
    </message>
    <message>
        <source>15° to the left</source>
        <translation>向左 15°</translation>
    </message>
    <message>
        <source>15° to the right</source>
        <translation>向右 15°</translation>
    </message>
    <message>
        <source>15° up</source>
        <translation>向上 15°</translation>
    </message>
    <message>
        <source>15° down</source>
        <translation>向下 15°</translation>
    </message>
    <message>
        <source>Void, P_v</source>
        <translation>未知，P_v</translation>
    </message>
    <message>
        <source>Seen, P_s</source>
        <translation>已见，P_s</translation>
    </message>
    <message>
        <source>Scanner, P_c</source>
        <translation>扫描仪，P_c</translation>
    </message>
    <message>
        <source>Image in positional space</source>
        <translation>位置空间中的图像</translation>
    </message>
    <message>
        <source>All directions</source>
        <translation>所有方向</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>方向</translation>
    </message>
</context>
<context>
    <name>vantage::PositionalSpaceView</name>
    <message>
        <source>Positional space</source>
        <translation>位置空间</translation>
    </message>
    <message>
        <source>The model cannot be shown: %1</source>
        <translation>无法显示模型：%1</translation>
    </message>
</context>
<context>
    <name>vantage::PrintDialog</name>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Widest opening that is closed</source>
        <translation>封闭的最大开口</translation>
    </message>
    <message>
        <source>Leave loose pieces out</source>
        <translation>略去零散部分</translation>
    </message>
    <message>
        <source>Only the largest piece of the surface is written.</source>
        <translation>只写入表面的最大部分。</translation>
    </message>
    <message>
        <source>Fewer triangles, no farther from the model than</source>
        <translation>减少三角形，与模型相距不超过</translation>
    </message>
    <message>
        <source>The distance is measured afterwards, from both surfaces.</source>
        <translation>随后从两个表面测量距离。</translation>
    </message>
    <message>
        <source>Greatest distance from the model</source>
        <translation>与模型的最大距离</translation>
    </message>
    <message>
        <source>Only write what can be printed</source>
        <translation>只写入可打印的内容</translation>
    </message>
    <message>
        <source>One closed surface in one piece that passes nowhere through itself. Otherwise nothing is written, and you learn why.</source>
        <translation>一个封闭、一体且无自相交的表面。否则不写入，并说明原因。</translation>
    </message>
    <message>
        <source>Ready to print</source>
        <translation>打印准备</translation>
    </message>
    <message>
        <source>Close openings</source>
        <translation>封闭开口</translation>
    </message>
    <message>
        <source>all</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>up to a width</source>
        <translation>不超过某一宽度</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Unit of the file</source>
        <translation>文件单位</translation>
    </message>
    <message>
        <source>millimetres</source>
        <translation>毫米</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>英寸</translation>
    </message>
    <message>
        <source>Close &amp;openings:</source>
        <translation>封闭开口(&amp;O)：</translation>
    </message>
    <message>
        <source>&amp;Width:</source>
        <translation>宽度(&amp;W)：</translation>
    </message>
    <message>
        <source>&amp;Distance:</source>
        <translation>距离(&amp;D)：</translation>
    </message>
    <message>
        <source>&amp;Unit:</source>
        <translation>单位(&amp;U)：</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>导出(&amp;E)…</translation>
    </message>
    <message>
        <source>What closes an opening is made up: nobody measured it. PLY and 3MF mark it; STL and OBJ cannot. The session stays as it is.</source>
        <translation>封闭开口的部分是虚构的，并未测量。PLY 和 3MF 会标明；STL 和 OBJ 不能。会话保持不变。</translation>
    </message>
</context>
<context>
    <name>vantage::RecentList</name>
    <message>
        <source>Go on with a session</source>
        <translation>继续会话</translation>
    </message>
    <message>
        <source>Sessions of lately</source>
        <translation>最近的会话</translation>
    </message>
    <message>
        <source>&amp;Take off this list</source>
        <translation>从此列表移除(&amp;T)</translation>
    </message>
    <message>
        <source>No session was opened yet.</source>
        <translation>尚未打开过会话。</translation>
    </message>
    <message>
        <source>Open a session</source>
        <translation>打开会话</translation>
    </message>
    <message>
        <source>%1 is gone.</source>
        <translation>%1 已不存在。</translation>
    </message>
    <message>
        <source>There is no file %1 any more. It may have been moved, or its drive is not connected.</source>
        <translation>文件 %1 已不存在。它可能已被移动，或其驱动器未连接。</translation>
    </message>
    <message>
        <source>&amp;Take off the list</source>
        <translation>从列表移除(&amp;T)</translation>
    </message>
</context>
<context>
    <name>vantage::RecentSessions</name>
    <message>
        <source>gone: no such file</source>
        <translation>已不存在：没有此文件</translation>
    </message>
    <message>
        <source>open now</source>
        <translation>当前已打开</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>无法读取</translation>
    </message>
    <message>
        <source>not read yet</source>
        <translation>尚未读取</translation>
    </message>
    <message>
        <source>%1
%2</source>
        <translation>%1
%2</translation>
    </message>
    <message>
        <source>changed %1</source>
        <translation>更改于 %1</translation>
    </message>
</context>
<context>
    <name>vantage::RegionDrawing</name>
    <message>
        <source>Draw around what is to be erased</source>
        <translation>圈出要擦除的部分</translation>
    </message>
</context>
<context>
    <name>vantage::ResultWriter</name>
    <message>
        <source>Writing %1</source>
        <translation>正在写入 %1</translation>
    </message>
</context>
<context>
    <name>vantage::ReviewPage</name>
    <message>
        <source>did not fit</source>
        <translation>未吻合</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>已略去</translation>
    </message>
    <message>
        <source>waits</source>
        <translation>等待</translation>
    </message>
    <message>
        <source>stand %1</source>
        <translation>摆放 %1</translation>
    </message>
    <message>
        <source>good</source>
        <translation>良好</translation>
    </message>
    <message>
        <source>doubtful</source>
        <translation>存疑</translation>
    </message>
    <message>
        <source>Read as: %1.</source>
        <translation>读取为：%1。</translation>
    </message>
    <message>
        <source>&amp;Leave this view out</source>
        <translation>略去此视图(&amp;L)</translation>
    </message>
    <message>
        <source>Make the model without this view, or take it back. The scan is kept.</source>
        <translation>生成不含此视图的模型，或将其恢复。扫描会保留。</translation>
    </message>
    <message>
        <source>T&amp;urn the object over…</source>
        <translation>翻转物体(&amp;U)…</translation>
    </message>
    <message>
        <source>Put the object on another side, to scan what this stand hides.</source>
        <translation>将物体换一面放置，以扫描此摆放遮住的部分。</translation>
    </message>
    <message>
        <source>What is left, and why</source>
        <translation>剩余部分及原因</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>视图</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>扫描</translation>
    </message>
    <message>
        <source>Pos.</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>New mm²</source>
        <translation>新增 mm²</translation>
    </message>
    <message>
        <source>Fit mm</source>
        <translation>吻合 mm</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>判定</translation>
    </message>
    <message>
        <source>Choose a scan in the list first.</source>
        <translation>请先在列表中选择扫描。</translation>
    </message>
    <message>
        <source>&amp;Take this view back</source>
        <translation>恢复此视图(&amp;T)</translation>
    </message>
    <message>
        <source>Nothing has been scanned yet.</source>
        <translation>尚未扫描任何内容。</translation>
    </message>
    <message>
        <source>Views in this stand</source>
        <translation>此摆放中的视图</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>表面</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>三角形</translation>
    </message>
    <message>
        <source>Not known: nothing is planned from recorded scans.</source>
        <translation>未知：录制的扫描不做规划。</translation>
    </message>
    <message>
        <source>Of this stand alone:</source>
        <translation>仅此摆放：</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>显示</translation>
    </message>
    <message>
        <source>%1 mm of edge</source>
        <translation>边长 %1 mm</translation>
    </message>
    <message>
        <source>Nothing: the surface is closed.</source>
        <translation>无：表面已封闭。</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Stand %1: </source>
        <translation>摆放 %1：</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>检查</translation>
    </message>
    <message>
        <source>Model and report are written where you say.</source>
        <translation>模型和报告将写到您指定之处。</translation>
    </message>
    <message>
        <source>&amp;Next: finish</source>
        <translation>下一步：完成(&amp;N)</translation>
    </message>
</context>
<context>
    <name>vantage::ScanList</name>
    <message>
        <source>Range files</source>
        <translation>距离文件</translation>
    </message>
    <message>
        <source>Range file</source>
        <translation>距离文件</translation>
    </message>
    <message>
        <source>Taken from position</source>
        <translation>采集位置</translation>
    </message>
    <message>
        <source>Add fil&amp;es…</source>
        <translation>添加文件(&amp;E)…</translation>
    </message>
    <message>
        <source>Add range files; they can also be dropped here.</source>
        <translation>添加距离文件；也可拖放到此处。</translation>
    </message>
    <message>
        <source>Range files (%1);;All files (*)</source>
        <translation>距离文件 (%1);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Add &amp;folder…</source>
        <translation>添加文件夹(&amp;F)…</translation>
    </message>
    <message>
        <source>Add all range files of a folder, by name.</source>
        <translation>按名称添加文件夹中的所有距离文件。</translation>
    </message>
    <message>
        <source>Folder of range files</source>
        <translation>距离文件的文件夹</translation>
    </message>
    <message>
        <source>Re&amp;move</source>
        <translation>移除(&amp;M)</translation>
    </message>
    <message>
        <source>Take the chosen files off the list.</source>
        <translation>将所选文件从列表中移除。</translation>
    </message>
    <message>
        <source>&amp;Up</source>
        <translation>上移(&amp;U)</translation>
    </message>
    <message>
        <source>Use the chosen file earlier.</source>
        <translation>提前使用所选文件。</translation>
    </message>
    <message>
        <source>&amp;Down</source>
        <translation>下移(&amp;D)</translation>
    </message>
    <message>
        <source>Use the chosen file later.</source>
        <translation>推后使用所选文件。</translation>
    </message>
    <message>
        <source>Position of %1</source>
        <translation>%1 的位置</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>未知</translation>
    </message>
</context>
<context>
    <name>vantage::ScannerPictureView</name>
    <message>
        <source>What the scanner would see</source>
        <translation>扫描仪将看到的内容</translation>
    </message>
    <message>
        <source>No position chosen</source>
        <translation>未选择位置</translation>
    </message>
</context>
<context>
    <name>vantage::SectionBar</name>
    <message>
        <source>Other side</source>
        <translation>另一侧</translation>
    </message>
    <message>
        <source>Cut across %1</source>
        <translation>垂直于 %1 剖切</translation>
    </message>
    <message>
        <source>Axis of the cut</source>
        <translation>剖切轴</translation>
    </message>
    <message>
        <source>The axis that the plane of the cut stands across.</source>
        <translation>与剖切平面垂直的轴。</translation>
    </message>
    <message>
        <source>Place of the cut</source>
        <translation>剖切位置</translation>
    </message>
    <message>
        <source>Where the cut is; the arrow keys move it, too.</source>
        <translation>剖切所在位置；也可用方向键移动。</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Place of the cut in millimetres</source>
        <translation>剖切位置（毫米）</translation>
    </message>
    <message>
        <source>Where on the axis the cut is.</source>
        <translation>剖切在轴上的位置。</translation>
    </message>
    <message>
        <source>Take away what is below the cut, not what is above.</source>
        <translation>去掉剖面以下的部分，而不是以上的部分。</translation>
    </message>
</context>
<context>
    <name>vantage::SessionController</name>
    <message>
        <source>Preparing the set-up</source>
        <translation>正在准备设置</translation>
    </message>
    <message>
        <source>Adding scans</source>
        <translation>正在添加扫描</translation>
    </message>
    <message>
        <source>Acquiring</source>
        <translation>采集</translation>
    </message>
    <message>
        <source>Scanning</source>
        <translation>扫描</translation>
    </message>
    <message>
        <source>Changing the session</source>
        <translation>正在更改会话</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>撤销</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>重做</translation>
    </message>
    <message>
        <source>Showing an earlier moment</source>
        <translation>正在显示较早的时刻</translation>
    </message>
</context>
<context>
    <name>vantage::SessionDoor</name>
    <message>
        <source>Open a session to look at</source>
        <translation>打开会话以查看</translation>
    </message>
    <message>
        <source>Open a session</source>
        <translation>打开会话</translation>
    </message>
    <message>
        <source>Sessions (*.vantage)</source>
        <translation>会话 (*.vantage)</translation>
    </message>
    <message>
        <source>%1 is open already.</source>
        <translation>%1 已经打开。</translation>
    </message>
    <message>
        <source>You can look at it as it is now: everything is shown and can be exported, nothing is changed.</source>
        <translation>您可以查看其当前状态：一切都会显示并可导出，不作任何更改。</translation>
    </message>
    <message>
        <source>&amp;Open to look at</source>
        <translation>打开以查看(&amp;O)</translation>
    </message>
    <message>
        <source>Not taken</source>
        <translation>未采用</translation>
    </message>
    <message>
        <source>%1 is a mesh. A mesh can be dropped on the first page, as what the simulated scanner looks at.</source>
        <translation>%1 是网格。网格可拖放到第一页，作为模拟扫描仪所看的物体。</translation>
    </message>
    <message>
        <source>%1 is a mesh. %2</source>
        <translation>%1 是网格。%2</translation>
    </message>
    <message>
        <source>A mesh</source>
        <translation>网格</translation>
    </message>
    <message>
        <source>%1 is a mesh.</source>
        <translation>%1 是网格。</translation>
    </message>
    <message>
        <source>The simulated scanner can look at it. Its file is only read.</source>
        <translation>模拟扫描仪可以看它。其文件只被读取。</translation>
    </message>
    <message>
        <source>&amp;Scan it in simulation</source>
        <translation>模拟扫描(&amp;S)</translation>
    </message>
</context>
<context>
    <name>vantage::SessionKeeper</name>
    <message>
        <source>Opening the session</source>
        <translation>正在打开会话</translation>
    </message>
    <message>
        <source>Importing recorded scans</source>
        <translation>正在导入录制的扫描</translation>
    </message>
</context>
<context>
    <name>vantage::SessionLog</name>
    <message>
        <source>Written: %1</source>
        <translation>已写入：%1</translation>
    </message>
    <message>
        <source>Session: %1</source>
        <translation>会话：%1</translation>
    </message>
    <message>
        <source>Opened after %1 steps; the last one: %2</source>
        <translation>已打开，共 %1 步；最后一步：%2</translation>
    </message>
    <message>
        <source>Undone: %1</source>
        <translation>已撤销：%1</translation>
    </message>
    <message>
        <source>Redone: %1</source>
        <translation>已重做：%1</translation>
    </message>
</context>
<context>
    <name>vantage::SessionViews</name>
    <message>
        <source>This is the session as it was after view %1. Back to now</source>
        <translation>这是视图 %1 之后的会话。返回当前</translation>
    </message>
</context>
<context>
    <name>vantage::SettingsDialog</name>
    <message>
        <source>Settings</source>
        <translation>设置</translation>
    </message>
    <message>
        <source>The window speaks it after it was closed and opened again.</source>
        <translation>关闭并重新打开窗口后生效。</translation>
    </message>
</context>
<context>
    <name>vantage::SettingsForm</name>
    <message>
        <source>Options for experts</source>
        <translation>专家选项</translation>
    </message>
    <message>
        <source>Show the options of every operation.</source>
        <translation>显示每个操作的选项。</translation>
    </message>
    <message>
        <source>Load options…</source>
        <translation>加载选项…</translation>
    </message>
    <message>
        <source>Take all options from a file that was saved before.</source>
        <translation>从以前保存的文件读取所有选项。</translation>
    </message>
    <message>
        <source>Save options…</source>
        <translation>保存选项…</translation>
    </message>
    <message>
        <source>Keep all options in a file, for here and for the command line.</source>
        <translation>将所有选项保存到文件，供此处和命令行使用。</translation>
    </message>
    <message>
        <source>Load options</source>
        <translation>加载选项</translation>
    </message>
    <message>
        <source>Options (*.json)</source>
        <translation>选项 (*.json)</translation>
    </message>
    <message>
        <source>Save options</source>
        <translation>保存选项</translation>
    </message>
</context>
<context>
    <name>vantage::StandBox</name>
    <message>
        <source>Align no&amp;w</source>
        <translation>立即对齐(&amp;W)</translation>
    </message>
    <message>
        <source>Find out how the object stands from what has been scanned of it so far.</source>
        <translation>根据已扫描的内容找出物体的姿态。</translation>
    </message>
    <message>
        <source>Compare poses…</source>
        <translation>比较位姿…</translation>
    </message>
    <message>
        <source>See the stand over the object in every pose that was found, choose one, or pick points.</source>
        <translation>查看摆放在每个位姿下与物体的叠放，选择其一，或选取点。</translation>
    </message>
    <message>
        <source>Turn again…</source>
        <translation>再次翻转…</translation>
    </message>
    <message>
        <source>Put the object on another side. The scans of this stand are kept, and tried again then.</source>
        <translation>将物体换一面放置。此摆放的扫描会保留，届时再次尝试。</translation>
    </message>
    <message>
        <source>Undo this stand: what was scanned in it is left, and can be redone. To scan on then, the object has to stand as if it had never been moved; else turn it over again.</source>
        <translation>撤销此摆放：其中的扫描被放下，可以重做。之后若要继续扫描，物体须如同从未移动过；否则请再次翻转。</translation>
    </message>
    <message>
        <source>Bac&amp;k to one stand</source>
        <translation>退回到一个摆放(&amp;K)</translation>
    </message>
    <message>
        <source>Bac&amp;k to %1 stands</source>
        <translation>退回到 %1 个摆放(&amp;K)</translation>
    </message>
</context>
<context>
    <name>vantage::StandDesk</name>
    <message>
        <source>Looking for sides to put the object on</source>
        <translation>正在查找物体可放置的面</translation>
    </message>
    <message>
        <source>It was stopped.</source>
        <translation>已停止。</translation>
    </message>
    <message>
        <source>From its third view on that is tried after every scan.</source>
        <translation>从第三个视图起，每次扫描后都会尝试。</translation>
    </message>
    <message>
        <source>The object stands as it did at first.</source>
        <translation>物体仍如最初那样摆放。</translation>
    </message>
</context>
<context>
    <name>vantage::StandDialog</name>
    <message>
        <source>&amp;Look for poses</source>
        <translation>查找位姿(&amp;L)</translation>
    </message>
    <message>
        <source>Searches all turns for poses of this stand, and checks them against the scans.</source>
        <translation>在所有转角中查找此摆放的位姿，并用扫描检验。</translation>
    </message>
    <message>
        <source>&amp;Pick points…</source>
        <translation>选取点(&amp;P)…</translation>
    </message>
    <message>
        <source>Click the same places on object and stand, where no pose is found without them.</source>
        <translation>当没有它们就找不到位姿时，点击物体和摆放上的相同位置。</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Closes this window.</source>
        <translation>关闭此窗口。</translation>
    </message>
    <message>
        <source>How the stands lie in each other</source>
        <translation>各摆放的相互位置</translation>
    </message>
    <message>
        <source>Stand %1</source>
        <translation>摆放 %1</translation>
    </message>
    <message>
        <source>Stand that is not in place yet</source>
        <translation>尚未就位的摆放</translation>
    </message>
    <message>
        <source>&amp;Back to the poses</source>
        <translation>返回位姿(&amp;B)</translation>
    </message>
    <message>
        <source>Looking at the points</source>
        <translation>正在查看点</translation>
    </message>
    <message>
        <source>Something else is under way.</source>
        <translation>其他操作正在进行。</translation>
    </message>
    <message>
        <source>The stand is in place already. Undo the step to choose again.</source>
        <translation>摆放已就位。请撤销该步骤后重新选择。</translation>
    </message>
    <message>
        <source>The stand is not ready to be looked at yet.</source>
        <translation>摆放尚不能查看。</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
</context>
<context>
    <name>vantage::StandInspector</name>
    <message>
        <source>Comparing stand %1 with the object</source>
        <translation>正在比较摆放 %1 与物体</translation>
    </message>
    <message>
        <source>Stopped. Open this window again to look at the stand.</source>
        <translation>已停止。请重新打开此窗口以查看摆放。</translation>
    </message>
    <message>
        <source>Looking at the poses</source>
        <translation>正在查看位姿</translation>
    </message>
</context>
<context>
    <name>vantage::StandSides</name>
    <message>
        <source>Sides that the object can rest on, the best first</source>
        <translation>物体可放置的面，最佳者在前</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1 · again</source>
        <translation>%1 · 再次</translation>
    </message>
    <message>
        <source>%1 of what is still unseen, %2 of what is left. It tilts by %3 before it falls over.</source>
        <translation>%1 的未见部分，占剩余的 %2。可倾斜 %3 而不倒。</translation>
    </message>
    <message>
        <source>It stood like this already.</source>
        <translation>已这样摆放过。</translation>
    </message>
</context>
<context>
    <name>vantage::StandStrip</name>
    <message>
        <source>Stands of the object</source>
        <translation>物体的摆放</translation>
    </message>
    <message>
        <source>Stand %1 · %2</source>
        <translation>摆放 %1 · %2</translation>
    </message>
    <message>
        <source>%1 (undone)</source>
        <translation>%1（已撤销）</translation>
    </message>
    <message>
        <source>Stand %1</source>
        <translation>摆放 %1</translation>
    </message>
</context>
<context>
    <name>vantage::StandView</name>
    <message>
        <source>The object as it would stand</source>
        <translation>物体将如何摆放</translation>
    </message>
</context>
<context>
    <name>vantage::TableCalibrating</name>
    <message>
        <source>Something else is under way.</source>
        <translation>其他操作正在进行。</translation>
    </message>
    <message>
        <source>Scanner and object are not read yet.</source>
        <translation>扫描仪和物体尚未读取。</translation>
    </message>
    <message>
        <source>A simulated table needs no calibration.</source>
        <translation>模拟转台无需标定。</translation>
    </message>
    <message>
        <source>Only a table that turns by itself has an angle that can be calibrated.</source>
        <translation>只有自行转动的转台才有可标定的角度。</translation>
    </message>
    <message>
        <source>Calibrating the table</source>
        <translation>正在标定转台</translation>
    </message>
    <message>
        <source>Writing the calibration</source>
        <translation>正在写入标定</translation>
    </message>
</context>
<context>
    <name>vantage::TestScanBox</name>
    <message>
        <source>Take &amp;a test scan</source>
        <translation>测试扫描(&amp;A)</translation>
    </message>
    <message>
        <source>Scan once from the first position and look at what is used of it. The scan is not kept.</source>
        <translation>从首个位置扫描一次，查看其中使用的部分。扫描不保留。</translation>
    </message>
    <message>
        <source>The session that is open keeps what it was begun with.</source>
        <translation>打开的会话保持其开始时的设置。</translation>
    </message>
    <message>
        <source>A test scan shows what the scanner sees, and what of that is taken for the object.</source>
        <translation>测试扫描显示扫描仪所见，以及其中哪些视为物体。</translation>
    </message>
    <message>
        <source>Nothing of the scan is used: look whether the object stands inside the viewing volume, and whether too much is cut.</source>
        <translation>扫描中没有可用的部分：请检查物体是否在测量空间内，以及是否裁剪过多。</translation>
    </message>
    <message>
        <source>1 sample</source>
        <translation>1 个采样点</translation>
    </message>
    <message>
        <source>%1 samples</source>
        <translation>%1 个采样点</translation>
    </message>
</context>
<context>
    <name>vantage::TestScans</name>
    <message>
        <source>Test turn</source>
        <translation>试转</translation>
    </message>
    <message>
        <source>Test scan</source>
        <translation>测试扫描</translation>
    </message>
</context>
<context>
    <name>vantage::TimeLine</name>
    <message>
        <source>Moments of the session</source>
        <translation>会话的各时刻</translation>
    </message>
    <message>
        <source>%1 (undone)</source>
        <translation>%1（已撤销）</translation>
    </message>
</context>
<context>
    <name>vantage::ToolBar</name>
    <message>
        <source>Tools</source>
        <translation>工具</translation>
    </message>
</context>
<context>
    <name>vantage::TurnDial</name>
    <message>
        <source>Turn the table by %1</source>
        <translation>请将转台转动 %1</translation>
    </message>
</context>
<context>
    <name>vantage::TurnOverPage</name>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>&amp;Look again</source>
        <translation>重新查找(&amp;L)</translation>
    </message>
    <message>
        <source>Look for sides to put the object on.</source>
        <translation>查找物体可放置的面。</translation>
    </message>
    <message>
        <source>Sides that it can rest on</source>
        <translation>可放置的面</translation>
    </message>
    <message>
        <source>It s&amp;tands on this side now: scan on</source>
        <translation>已换到此面：继续扫描(&amp;T)</translation>
    </message>
    <message>
        <source>Begin a new stand. What was scanned before is kept aside until it is known how the object was turned over.</source>
        <translation>开始新的摆放。此前的扫描先搁置，直到得知物体如何翻转。</translation>
    </message>
    <message>
        <source>Scan on, or go to the review without. How it was turned over is found out by itself.</source>
        <translation>继续扫描，或直接进入检查。翻转方式会自动求出。</translation>
    </message>
    <message>
        <source>Looking for the side that would show most.</source>
        <translation>正在查找能显示最多的面。</translation>
    </message>
    <message>
        <source>Nothing is known of its sides yet.</source>
        <translation>对各面尚一无所知。</translation>
    </message>
    <message>
        <source>Nothing has been scanned yet.</source>
        <translation>尚未扫描任何内容。</translation>
    </message>
    <message>
        <source>There is no model of the object: nothing can be said of its sides.</source>
        <translation>没有物体的模型：无法判断各面。</translation>
    </message>
    <message>
        <source>What is known of the object spans no volume, so it is not known what it can rest on. Scan more first.</source>
        <translation>物体已知的部分不构成体积，因此不知道它可放在哪一面。请先多扫描。</translation>
    </message>
    <message>
        <source>Nothing is left that another stand could show: the surface is closed.</source>
        <translation>没有其他摆放能显示的部分：表面已封闭。</translation>
    </message>
    <message>
        <source>Nothing more is to be gained: no other side would show more than %1, which a stand has to be worth. %2 of what is still unseen no side shows at all: it lies in hollows or too steep from everywhere.</source>
        <translation>无法获得更多：没有其他面能显示超过 %1，而这是一个摆放所需的最小值。未见部分中有 %2 任何面都看不到：它们在凹陷处或从任何位置看都过陡。</translation>
    </message>
    <message>
        <source>On another side the scanner would see up to %1 of what is still unseen, %2 of what is left.</source>
        <translation>换一面后扫描仪最多可看到 %1 的未见部分，占剩余的 %2。</translation>
    </message>
    <message>
        <source>The simulated object is turned over by itself: it comes to rest on the side nearest to this one, turned at random and a little beside the axis.</source>
        <translation>模拟物体会自动翻转：它落在与此最接近的面上，随机转动，并略偏离轴。</translation>
    </message>
    <message>
        <source>Put it on that side anywhere near the axis, turned in any way: how it stands is found out.</source>
        <translation>将其以此面放在轴附近任意处，转向任意：其姿态会自动求出。</translation>
    </message>
    <message>
        <source>If it would not rest like this, take the picture that is nearest to how it does.</source>
        <translation>如果不能这样放稳，请选与实际摆放最接近的图。</translation>
    </message>
    <message>
        <source>What holds it is scanned with it, save what lies at the height of the table, which is cut out: hold it with as little as will do.</source>
        <translation>支撑物会一同被扫描，只有转台高度处的部分会裁掉：请用尽量少的支撑。</translation>
    </message>
    <message>
        <source>What holds it is scanned with it, and so is the table: nothing is cut out of these scans.</source>
        <translation>支撑物和转台都会一同被扫描：这些扫描不做裁剪。</translation>
    </message>
    <message>
        <source>Something else is under way.</source>
        <translation>其他操作正在进行。</translation>
    </message>
    <message>
        <source>There is no side to put it on yet.</source>
        <translation>还没有可放置的面。</translation>
    </message>
    <message>
        <source>It would show</source>
        <translation>可显示</translation>
    </message>
    <message>
        <source>%1 of what is left</source>
        <translation>占剩余的 %1</translation>
    </message>
    <message>
        <source>It falls over beyond a tilt of</source>
        <translation>倾倒角度</translation>
    </message>
    <message>
        <source>easily: hold it, or take another side</source>
        <translation>容易倾倒：请扶住，或换另一面</translation>
    </message>
    <message>
        <source>It stood like this</source>
        <translation>这样摆放</translation>
    </message>
    <message>
        <source>already</source>
        <translation>已有过</translation>
    </message>
    <message>
        <source>Turn the object over</source>
        <translation>翻转物体</translation>
    </message>
    <message>
        <source>&amp;Next: review</source>
        <translation>下一步：检查(&amp;N)</translation>
    </message>
</context>
<context>
    <name>vantage::Undertaking</name>
    <message>
        <source>Nothing runs that could pause.</source>
        <translation>没有可暂停的操作。</translation>
    </message>
    <message>
        <source>Nothing runs that could be stopped.</source>
        <translation>没有可停止的操作。</translation>
    </message>
    <message>
        <source>%1: stopped</source>
        <translation>%1：已停止</translation>
    </message>
</context>
<context>
    <name>vantage::UnrolledMapView</name>
    <message>
        <source>Positional space, unrolled</source>
        <translation>位置空间（展开）</translation>
    </message>
    <message>
        <source>No plan yet</source>
        <translation>尚无规划</translation>
    </message>
</context>
<context>
    <name>vantage::ViewActions</name>
    <message>
        <source>Measure anew</source>
        <translation>重新测量</translation>
    </message>
    <message>
        <source>Forgets both places.</source>
        <translation>清除两处位置。</translation>
    </message>
    <message>
        <source>&amp;Wireframe</source>
        <translation>线框(&amp;W)</translation>
    </message>
    <message>
        <source>Ctrl+Shift+W</source>
        <translation>Ctrl+Shift+W</translation>
    </message>
    <message>
        <source>Only the edges of the triangles</source>
        <translation>仅三角形的边</translation>
    </message>
    <message>
        <source>&amp;Points</source>
        <translation>点(&amp;P)</translation>
    </message>
    <message>
        <source>Ctrl+Shift+P</source>
        <translation>Ctrl+Shift+P</translation>
    </message>
    <message>
        <source>Only the corners of the triangles</source>
        <translation>仅三角形的顶点</translation>
    </message>
    <message>
        <source>&amp;Back faces in red</source>
        <translation>背面显示为红色(&amp;B)</translation>
    </message>
    <message>
        <source>Ctrl+Shift+B</source>
        <translation>Ctrl+Shift+B</translation>
    </message>
    <message>
        <source>Where a surface is seen from its inside</source>
        <translation>从内侧看到表面之处</translation>
    </message>
    <message>
        <source>Parallel p&amp;rojection</source>
        <translation>平行投影(&amp;R)</translation>
    </message>
    <message>
        <source>Ctrl+Shift+G</source>
        <translation>Ctrl+Shift+G</translation>
    </message>
    <message>
        <source>What is far is as large as what is near</source>
        <translation>远处与近处同样大小</translation>
    </message>
    <message>
        <source>&amp;Cut by a plane</source>
        <translation>用平面剖切(&amp;C)</translation>
    </message>
    <message>
        <source>Ctrl+Shift+X</source>
        <translation>Ctrl+Shift+X</translation>
    </message>
    <message>
        <source>Takes away what is on one side of a plane</source>
        <translation>去掉平面一侧的部分</translation>
    </message>
    <message>
        <source>&amp;Measure between two places</source>
        <translation>测量两处之间(&amp;M)</translation>
    </message>
    <message>
        <source>Ctrl+M</source>
        <translation>Ctrl+M</translation>
    </message>
    <message>
        <source>Click two places on the surface</source>
        <translation>点击表面上的两处</translation>
    </message>
    <message>
        <source>From 1 to 2: %1</source>
        <translation>从 1 至 2：%1</translation>
    </message>
    <message>
        <source>Click the first place on the surface.</source>
        <translation>请点击表面上的第一处。</translation>
    </message>
    <message>
        <source>Click the second place on the surface.</source>
        <translation>请点击表面上的第二处。</translation>
    </message>
    <message>
        <source>Nothing was measured yet.</source>
        <translation>尚未测量。</translation>
    </message>
</context>
<context>
    <name>vantage::VolumeSketch</name>
    <message>
        <source>Object in the viewing volume</source>
        <translation>测量空间中的物体</translation>
    </message>
    <message>
        <source>⌀ %1 mm, %2 mm high</source>
        <translation>⌀ %1 mm，高 %2 mm</translation>
    </message>
</context>
<context>
    <name>vantage::WhyPanel</name>
    <message>
        <source>Unseen edges from there</source>
        <translation>从该处看的未见边</translation>
    </message>
    <message>
        <source>No position yet</source>
        <translation>尚无位置</translation>
    </message>
    <message>
        <source>Once a view is planned it is explained here. Click any position in the objective to ask why it was not proposed.</source>
        <translation>规划视图后在此解释。点击目标函数中的任意位置，可查询为何没有建议它。</translation>
    </message>
    <message>
        <source>What the scanner would see from %1</source>
        <translation>扫描仪从 %1 将看到的内容</translation>
    </message>
</context>
<context>
    <name>vantage::Wizard</name>
    <message>
        <source>&amp;Back</source>
        <translation>上一步(&amp;B)</translation>
    </message>
    <message>
        <source>The page before; nothing is lost.</source>
        <translation>前一页；不会丢失任何内容。</translation>
    </message>
    <message>
        <source>What happens next</source>
        <translation>接下来会发生什么</translation>
    </message>
    <message>
        <source>Step %1 of %2</source>
        <translation>第 %1 步，共 %2 步</translation>
    </message>
    <message>
        <source>Between step %1 and step %2 of %3</source>
        <translation>第 %1 步与第 %2 步之间，共 %3 步</translation>
    </message>
    <message>
        <source>This is the first page.</source>
        <translation>这是第一页。</translation>
    </message>
</context>
<context>
    <name>vantage::WizardPage</name>
    <message>
        <source>Something else is under way.</source>
        <translation>其他操作正在进行。</translation>
    </message>
    <message>
        <source>Nothing has been scanned yet.</source>
        <translation>尚未扫描任何内容。</translation>
    </message>
    <message>
        <source>Scanner and object are not read yet.</source>
        <translation>扫描仪和物体尚未读取。</translation>
    </message>
    <message>
        <source>E&amp;rase what is not the object…</source>
        <translation>擦除非物体的部分(&amp;R)…</translation>
    </message>
    <message>
        <source>Take putty, a clamp, the table or loose pieces out of the model.</source>
        <translation>从模型中去掉油泥、夹具、转台或零散部分。</translation>
    </message>
    <message>
        <source>An earlier moment is shown: go back to now first.</source>
        <translation>显示的是较早的时刻：请先返回当前。</translation>
    </message>
</context>
</TS>
