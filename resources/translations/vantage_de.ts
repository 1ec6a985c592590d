<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en">
<context>
    <name>CalibratePage</name>
    <message>
        <source>The table is calibrated.</source>
        <translation>Der Drehtisch ist kalibriert.</translation>
    </message>
    <message>
        <source>The table is calibrated, but something about it is in doubt.</source>
        <translation>Der Drehtisch ist kalibriert, aber etwas daran ist zweifelhaft.</translation>
    </message>
    <message>
        <source>The table could not be calibrated.</source>
        <translation>Der Drehtisch konnte nicht kalibriert werden.</translation>
    </message>
</context>
<context>
    <name>Completeness</name>
    <message>
        <source>Nothing has to be done: it can be printed and measured as it is.</source>
        <translation>Es ist nichts zu tun: Das Modell kann so gedruckt und gemessen werden.</translation>
    </message>
    <message>
        <source>Scan on: position %1 would show %2.</source>
        <translation>Weiter scannen: Position %1 würde %2 zeigen.</translation>
    </message>
    <message>
        <source>What is open was not seen by these scans: add scans that see it, or close the openings when the model is used.</source>
        <translation>Was offen ist, haben diese Scans nicht gesehen: Fügen Sie Scans hinzu, die es sehen, oder schließen Sie die Öffnungen bei der Verwendung des Modells.</translation>
    </message>
    <message>
        <source>No position of this scanner sees the rest as the object stands: turn it over.</source>
        <translation>Keine Position dieses Scanners sieht den Rest, so wie das Objekt steht: Wenden Sie es.</translation>
    </message>
    <message>
        <source>No position of this scanner sees the rest as the object stands: turn it over, or tilt the scanner.</source>
        <translation>Keine Position dieses Scanners sieht den Rest, so wie das Objekt steht: Wenden Sie es, oder neigen Sie den Scanner.</translation>
    </message>
    <message>
        <source>Little is left that a view would show. Turn the object over to see its underside, or finish.</source>
        <translation>Eine weitere Ansicht würde wenig Neues zeigen. Wenden Sie das Objekt, um die Unterseite zu sehen, oder schließen Sie ab.</translation>
    </message>
    <message>
        <source>What is open was not seen: scan on, or turn the object over.</source>
        <translation>Was offen ist, wurde nicht gesehen: Scannen Sie weiter, oder wenden Sie das Objekt.</translation>
    </message>
    <message>
        <source>The surface is closed.</source>
        <translation>Die Oberfläche ist geschlossen.</translation>
    </message>
    <message>
        <source>%1 of what the scanner reaches is covered.</source>
        <translation>%1 dessen, was der Scanner erreicht, ist erfasst.</translation>
    </message>
    <message>
        <source>The surface has 1 opening.</source>
        <translation>Die Oberfläche hat 1 Öffnung.</translation>
    </message>
    <message>
        <source>The surface has %1 openings.</source>
        <translation>Die Oberfläche hat %1 Öffnungen.</translation>
    </message>
    <message>
        <source>Of the whole surface, at most</source>
        <translation>Von der ganzen Oberfläche höchstens</translation>
    </message>
    <message>
        <source>as far as its openings tell; behind them there may be more</source>
        <translation>soweit ihre Öffnungen es zeigen; dahinter kann mehr liegen</translation>
    </message>
    <message>
        <source>Openings</source>
        <translation>Öffnungen</translation>
    </message>
    <message>
        <source>Loose pieces</source>
        <translation>Lose Stücke</translation>
    </message>
    <message>
        <source>what joins them was not seen</source>
        <translation>was sie verbindet, wurde nicht gesehen</translation>
    </message>
    <message>
        <source>Closed, to be printed</source>
        <translation>Geschlossen, druckbar</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>What is open is where you erased what is not the object: turn the object over to see what was hidden there, or close the openings when the model is used.</source>
        <translation>Offen ist, wo Sie gelöscht haben, was nicht zum Objekt gehört: Wenden Sie das Objekt, um zu sehen, was dort verdeckt war, oder schließen Sie die Öffnungen bei der Verwendung des Modells.</translation>
    </message>
    <message>
        <source>%1 of them where you erased something</source>
        <translation>%1 davon, wo Sie etwas gelöscht haben</translation>
    </message>
</context>
<context>
    <name>CompositeScene</name>
    <message>
        <source>Object and stand</source>
        <translation>Objekt und Aufstellung</translation>
    </message>
    <message>
        <source>object</source>
        <translation>Objekt</translation>
    </message>
    <message>
        <source>stand</source>
        <translation>Aufstellung</translation>
    </message>
    <message>
        <source>on each other</source>
        <translation>aufeinander</translation>
    </message>
    <message>
        <source>contradicted</source>
        <translation>widerlegt</translation>
    </message>
    <message>
        <source>expected, not seen</source>
        <translation>erwartet, nicht gesehen</translation>
    </message>
</context>
<context>
    <name>DeviceBench</name>
    <message>
        <source>Ready.</source>
        <translation>Bereit.</translation>
    </message>
    <message>
        <source>At rest at %1°, as it reports.</source>
        <translation>Steht still bei %1°, wie er meldet.</translation>
    </message>
    <message>
        <source>Told to stand at %1°; it does not report.</source>
        <translation>Soll bei %1° stehen; er meldet es nicht.</translation>
    </message>
    <message>
        <source>Scanner</source>
        <translation>Scanner</translation>
    </message>
    <message>
        <source>Turntable</source>
        <translation>Drehtisch</translation>
    </message>
    <message>
        <source>Ready; where it stands is known after its first move.</source>
        <translation>Bereit; wo er steht, ist nach seiner ersten Bewegung bekannt.</translation>
    </message>
</context>
<context>
    <name>DroppedFiles</name>
    <message>
        <source>%1 is a list of poses: it is chosen where scans are imported.</source>
        <translation>%1 ist eine Liste von Posen: Sie wird beim Importieren von Scans gewählt.</translation>
    </message>
    <message>
        <source>%1 is a profile or a file of settings: it is chosen on the first page.</source>
        <translation>%1 ist ein Profil oder eine Einstellungsdatei: Sie wird auf der ersten Seite gewählt.</translation>
    </message>
    <message>
        <source>The folder %1 holds %2 sessions: drop the one that you mean.</source>
        <translation>Der Ordner %1 enthält %2 Sitzungen: Ziehen Sie die gewünschte auf das Fenster.</translation>
    </message>
    <message>
        <source>The folder %1 holds no session and no scans.</source>
        <translation>Der Ordner %1 enthält weder eine Sitzung noch Scans.</translation>
    </message>
    <message>
        <source>%1 is a session</source>
        <translation>%1 ist eine Sitzung</translation>
    </message>
    <message>
        <source>%1 is a mesh</source>
        <translation>%1 ist ein Netz</translation>
    </message>
    <message>
        <source>%1 is a scan</source>
        <translation>%1 ist ein Scan</translation>
    </message>
    <message>
        <source>Nothing that was dropped is a file of this computer.</source>
        <translation>Nichts davon ist eine Datei dieses Computers.</translation>
    </message>
    <message>
        <source>%1, %2: drop one kind at a time.</source>
        <translation>%1, %2: Ziehen Sie jeweils nur eine Art von Dateien auf das Fenster.</translation>
    </message>
    <message>
        <source>%1 and %2 are sessions: one is opened at a time.</source>
        <translation>%1 und %2 sind Sitzungen: Es wird jeweils nur eine geöffnet.</translation>
    </message>
    <message>
        <source>%1 and %2 are meshes: one is taken at a time.</source>
        <translation>%1 und %2 sind Netze: Es wird jeweils nur eines genommen.</translation>
    </message>
    <message>
        <source>A session or its folder, scans, or one mesh can be dropped here.</source>
        <translation>Eine Sitzung oder ihr Ordner, Scans oder ein Netz können hierher gezogen werden.</translation>
    </message>
</context>
<context>
    <name>Ending</name>
    <message>
        <source> Position %1 would still show %2.</source>
        <translation> Position %1 würde noch %2 zeigen.</translation>
    </message>
    <message>
        <source>If the table stood wrong, turn it to position %1 and take that once more.</source>
        <translation>Falls der Drehtisch falsch stand: Drehen Sie ihn auf Position %1, und scannen Sie dort noch einmal.</translation>
    </message>
    <message>
        <source>If the table stood wrong, take position %1 once more; else go on from position %2.</source>
        <translation>Falls der Drehtisch falsch stand: Scannen Sie noch einmal von Position %1; sonst fahren Sie mit Position %2 fort.</translation>
    </message>
    <message>
        <source>Ended: the views that were asked for are taken.</source>
        <translation>Beendet: Die gewünschten Ansichten sind aufgenommen.</translation>
    </message>
    <message>
        <source> from position %1</source>
        <translation> von Position %1</translation>
    </message>
    <message>
        <source>Scan %1%2 did not fit: %3.</source>
        <translation>Scan %1%2 passte nicht: %3.</translation>
    </message>
    <message>
        <source> It is kept, but not part of the model. </source>
        <translation> Er bleibt erhalten, gehört aber nicht zum Modell. </translation>
    </message>
</context>
<context>
    <name>ImportDialog</name>
    <message>
        <source>millimetres</source>
        <translation>Millimeter</translation>
    </message>
    <message>
        <source>centimetres</source>
        <translation>Zentimeter</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>metres</source>
        <translation>Meter</translation>
    </message>
    <message>
        <source>along z, y down (a camera)</source>
        <translation>entlang z, y nach unten (eine Kamera)</translation>
    </message>
    <message>
        <source>along −z, y up (OpenGL)</source>
        <translation>entlang −z, y nach oben (OpenGL)</translation>
    </message>
    <message>
        <source>along x</source>
        <translation>entlang x</translation>
    </message>
    <message>
        <source>along −x</source>
        <translation>entlang −x</translation>
    </message>
    <message>
        <source>along y</source>
        <translation>entlang y</translation>
    </message>
    <message>
        <source>along −y</source>
        <translation>entlang −y</translation>
    </message>
    <message>
        <source>points are in the object&apos;s coordinates</source>
        <translation>die Punkte sind in den Koordinaten des Objekts</translation>
    </message>
    <message>
        <source>columns go around an axis</source>
        <translation>die Spalten laufen um eine Achse</translation>
    </message>
    <message>
        <source>points are in the coordinates of the profile</source>
        <translation>die Punkte sind in den Koordinaten des Profils</translation>
    </message>
</context>
<context>
    <name>JobPanel</name>
    <message>
        <source>scanning</source>
        <translation>Scannen</translation>
    </message>
    <message>
        <source>registering</source>
        <translation>Registrieren</translation>
    </message>
    <message>
        <source>preparing the views</source>
        <translation>Vorbereiten der Ansichten</translation>
    </message>
    <message>
        <source>refining all views</source>
        <translation>Verfeinern aller Ansichten</translation>
    </message>
    <message>
        <source>merging</source>
        <translation>Zusammenführen</translation>
    </message>
    <message>
        <source>finding what is unseen</source>
        <translation>Suchen nach Ungesehenem</translation>
    </message>
    <message>
        <source>projecting what is unseen</source>
        <translation>Projizieren des Ungesehenen</translation>
    </message>
    <message>
        <source>projecting what was seen</source>
        <translation>Projizieren des Gesehenen</translation>
    </message>
    <message>
        <source>choosing the next view</source>
        <translation>Wählen der nächsten Ansicht</translation>
    </message>
    <message>
        <source>joining surfaces</source>
        <translation>Verbinden der Oberflächen</translation>
    </message>
    <message>
        <source>moving the surface to where the views agree</source>
        <translation>Mitteln der Oberfläche über die Ansichten</translation>
    </message>
    <message>
        <source>preparing</source>
        <translation>Vorbereiten</translation>
    </message>
    <message>
        <source>searching</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>checking</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>finding the axis</source>
        <translation>Bestimmen der Achse</translation>
    </message>
    <message>
        <source>closing openings</source>
        <translation>Schließen von Öffnungen</translation>
    </message>
    <message>
        <source>taking fewer triangles</source>
        <translation>Verringern der Dreiecke</translation>
    </message>
    <message>
        <source>reading the profile</source>
        <translation>Lesen des Profils</translation>
    </message>
    <message>
        <source>reading the object</source>
        <translation>Lesen des Objekts</translation>
    </message>
    <message>
        <source>reading the session</source>
        <translation>Lesen der Sitzung</translation>
    </message>
    <message>
        <source>reading the scan</source>
        <translation>Lesen des Scans</translation>
    </message>
    <message>
        <source>reading the scans</source>
        <translation>Lesen der Scans</translation>
    </message>
    <message>
        <source>reading a recorded scan</source>
        <translation>Lesen eines aufgezeichneten Scans</translation>
    </message>
    <message>
        <source>positional space of the scanner</source>
        <translation>Positionsraum des Scanners</translation>
    </message>
    <message>
        <source>reading %1</source>
        <translation>%1 wird gelesen</translation>
    </message>
</context>
<context>
    <name>ModelView</name>
    <message>
        <source>edge against the background</source>
        <translation>Rand vor dem Hintergrund</translation>
    </message>
    <message>
        <source>hidden behind the object</source>
        <translation>verdeckt durch das Objekt</translation>
    </message>
    <message>
        <source>light or camera blocked</source>
        <translation>Licht oder Kamera verdeckt</translation>
    </message>
    <message>
        <source>open border</source>
        <translation>offener Rand</translation>
    </message>
    <message>
        <source>rim of the scan</source>
        <translation>Rand des Scans</translation>
    </message>
    <message>
        <source>open</source>
        <translation>offen</translation>
    </message>
    <message>
        <source>looked at, still open</source>
        <translation>angesehen, noch offen</translation>
    </message>
    <message>
        <source>answered: no surface found</source>
        <translation>beantwortet: keine Oberfläche gefunden</translation>
    </message>
    <message>
        <source>out of reach</source>
        <translation>außer Reichweite</translation>
    </message>
    <message>
        <source>too steep</source>
        <translation>zu steil</translation>
    </message>
    <message>
        <source>light blocked</source>
        <translation>Licht verdeckt</translation>
    </message>
    <message>
        <source>receiver blocked</source>
        <translation>Empfänger verdeckt</translation>
    </message>
    <message>
        <source>too little for a view</source>
        <translation>zu wenig für eine Ansicht</translation>
    </message>
    <message>
        <source>Unseen edges by kind</source>
        <translation>Ungesehene Ränder nach Art</translation>
    </message>
    <message>
        <source>Unseen edges by state</source>
        <translation>Ungesehene Ränder nach Zustand</translation>
    </message>
    <message>
        <source>Surface by view</source>
        <translation>Oberfläche nach Ansicht</translation>
    </message>
    <message>
        <source>view %1, position %2</source>
        <translation>Ansicht %1, Position %2</translation>
    </message>
    <message>
        <source>view %1</source>
        <translation>Ansicht %1</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>und %1 weitere</translation>
    </message>
    <message>
        <source>Surface by stand</source>
        <translation>Oberfläche nach Aufstellung</translation>
    </message>
    <message>
        <source>stand %1, 1 view</source>
        <translation>Aufstellung %1, 1 Ansicht</translation>
    </message>
    <message>
        <source>stand %1, %2 views</source>
        <translation>Aufstellung %1, %2 Ansichten</translation>
    </message>
    <message>
        <source>Surface in its colours</source>
        <translation>Oberfläche in ihren Farben</translation>
    </message>
    <message>
        <source>no colour was measured</source>
        <translation>keine Farbe gemessen</translation>
    </message>
    <message>
        <source>1 unseen edge</source>
        <translation>1 ungesehener Rand</translation>
    </message>
    <message>
        <source>%1 unseen edges</source>
        <translation>%1 ungesehene Ränder</translation>
    </message>
    <message>
        <source>Stand %1 alone after 1 view</source>
        <translation>Aufstellung %1 allein nach 1 Ansicht</translation>
    </message>
    <message>
        <source>Stand %1 alone after %2 views</source>
        <translation>Aufstellung %1 allein nach %2 Ansichten</translation>
    </message>
    <message>
        <source>Model after 1 view</source>
        <translation>Modell nach 1 Ansicht</translation>
    </message>
    <message>
        <source>Model after %1 views</source>
        <translation>Modell nach %1 Ansichten</translation>
    </message>
    <message>
        <source>Before the first scan</source>
        <translation>Vor dem ersten Scan</translation>
    </message>
    <message>
        <source>The scanner at position %1</source>
        <translation>Der Scanner an Position %1</translation>
    </message>
    <message>
        <source>The simulated object and the viewing volume</source>
        <translation>Das simulierte Objekt und das Messvolumen</translation>
    </message>
    <message>
        <source>The viewing volume</source>
        <translation>Das Messvolumen</translation>
    </message>
    <message>
        <source>No view taken yet</source>
        <translation>Noch keine Ansicht aufgenommen</translation>
    </message>
    <message>
        <source>No view of stand %1 taken yet</source>
        <translation>Noch keine Ansicht von Aufstellung %1 aufgenommen</translation>
    </message>
    <message>
        <source>The object is set aside meanwhile</source>
        <translation>Das Objekt ist solange zurückgestellt</translation>
    </message>
    <message>
        <source>Not put together with the object yet</source>
        <translation>Noch nicht mit dem Objekt zusammengefügt</translation>
    </message>
    <message>
        <source>%1 triangles</source>
        <translation>%1 Dreiecke</translation>
    </message>
    <message>
        <source>%1, %2 mm²</source>
        <translation>%1, %2 mm²</translation>
    </message>
    <message>
        <source>Confidence</source>
        <translation>Konfidenz</translation>
    </message>
    <message>
        <source>(1: seen head-on)</source>
        <translation>(1: senkrecht gesehen)</translation>
    </message>
    <message>
        <source>Surface by age</source>
        <translation>Oberfläche nach Alter</translation>
    </message>
    <message>
        <source>view</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Ranging rays</source>
        <translation>Messstrahlen</translation>
    </message>
    <message>
        <source>last view, position %1</source>
        <translation>letzte Ansicht, Position %1</translation>
    </message>
    <message>
        <source>examined position %1</source>
        <translation>betrachtete Position %1</translation>
    </message>
    <message>
        <source>your choice, position %1</source>
        <translation>Ihre Wahl, Position %1</translation>
    </message>
    <message>
        <source>proposed view, position %1</source>
        <translation>vorgeschlagene Ansicht, Position %1</translation>
    </message>
    <message>
        <source>Marks</source>
        <translation>Marken</translation>
    </message>
    <message>
        <source>border of the model</source>
        <translation>Rand des Modells</translation>
    </message>
    <message>
        <source>what the chosen scan brought</source>
        <translation>was der gewählte Scan brachte</translation>
    </message>
    <message>
        <source>where the scanner stands, position %1</source>
        <translation>wo der Scanner steht, Position %1</translation>
    </message>
    <message>
        <source>where it is next, position %1</source>
        <translation>wo er als Nächstes steht, Position %1</translation>
    </message>
    <message>
        <source>erased: not the object</source>
        <translation>gelöscht: nicht das Objekt</translation>
    </message>
    <message>
        <source>what would be erased</source>
        <translation>was gelöscht würde</translation>
    </message>
</context>
<context>
    <name>Moments</name>
    <message>
        <source>Session begun</source>
        <translation>Sitzung begonnen</translation>
    </message>
</context>
<context>
    <name>Notices</name>
    <message>
        <source>In the folder %1.</source>
        <translation>Im Ordner %1.</translation>
    </message>
    <message>
        <source>Vantage</source>
        <translation>Vantage</translation>
    </message>
    <message>
        <source>More happened meanwhile, see the details.</source>
        <translation>Inzwischen ist mehr geschehen, siehe Details.</translation>
    </message>
</context>
<context>
    <name>ObjectFigures</name>
    <message>
        <source>The object without it</source>
        <translation>Das Objekt ohne sie</translation>
    </message>
    <message>
        <source>%1 views; that is what is exported</source>
        <translation>%1 Ansichten; das wird exportiert</translation>
    </message>
</context>
<context>
    <name>ObjectiveView</name>
    <message>
        <source>%1, %2° up</source>
        <translation>%1, %2° hoch</translation>
    </message>
    <message>
        <source>Next view, your choice: position %1</source>
        <translation>Nächste Ansicht, Ihre Wahl: Position %1</translation>
    </message>
    <message>
        <source>Next best view: position %1</source>
        <translation>Nächste beste Ansicht: Position %1</translation>
    </message>
    <message>
        <source>Ended; position %1 would be next</source>
        <translation>Beendet; als Nächstes käme Position %1</translation>
    </message>
    <message>
        <source>No next view</source>
        <translation>Keine weitere Ansicht</translation>
    </message>
    <message>
        <source>, taken</source>
        <translation>, aufgenommen</translation>
    </message>
    <message>
        <source>, ruled out</source>
        <translation>, ausgeschlossen</translation>
    </message>
    <message>
        <source>void mm²</source>
        <translation>Leerraum mm²</translation>
    </message>
    <message>
        <source>overlap mm²</source>
        <translation>Überlappung mm²</translation>
    </message>
    <message>
        <source>Nothing is planned from recorded scans</source>
        <translation>Bei aufgezeichneten Scans wird nichts geplant</translation>
    </message>
    <message>
        <source>No plan yet</source>
        <translation>Noch kein Plan</translation>
    </message>
    <message>
        <source>F = %1</source>
        <translation>F = %1</translation>
    </message>
    <message>
        <source>o_s: overlap</source>
        <translation>o_s: Überlappung</translation>
    </message>
    <message>
        <source>t = %1</source>
        <translation>t = %1</translation>
    </message>
    <message>
        <source>now</source>
        <translation>jetzt</translation>
    </message>
    <message>
        <source>next</source>
        <translation>nächste</translation>
    </message>
    <message>
        <source>asked</source>
        <translation>gefragt</translation>
    </message>
    <message>
        <source>ruled out</source>
        <translation>gesperrt</translation>
    </message>
    <message>
        <source>position %1, at %2</source>
        <translation>Position %1, %2</translation>
    </message>
    <message>
        <source>would show %1, overlap %2</source>
        <translation>würde %1 zeigen, Überlappung %2</translation>
    </message>
    <message>
        <source>o_v: would show</source>
        <translation>o_v: würde zeigen</translation>
    </message>
</context>
<context>
    <name>Outlook</name>
    <message>
        <source>about %1 s</source>
        <translation>etwa %1 s</translation>
    </message>
    <message>
        <source>about %1 min</source>
        <translation>etwa %1 min</translation>
    </message>
    <message>
        <source>about %1 h</source>
        <translation>etwa %1 h</translation>
    </message>
    <message>
        <source>about 1 more view</source>
        <translation>noch etwa 1 Ansicht</translation>
    </message>
    <message>
        <source>about %1 more views</source>
        <translation>noch etwa %1 Ansichten</translation>
    </message>
    <message>
        <source>%1, %2 by an estimate</source>
        <translation>%1, %2 geschätzt</translation>
    </message>
</context>
<context>
    <name>Permissions</name>
    <message>
        <source>Something else is under way.</source>
        <translation>Etwas anderes läuft gerade.</translation>
    </message>
    <message>
        <source>This session is open to be looked at only.</source>
        <translation>Diese Sitzung ist nur zum Ansehen geöffnet.</translation>
    </message>
    <message>
        <source>Scanner and object are not read yet.</source>
        <translation>Scanner und Objekt sind noch nicht gelesen.</translation>
    </message>
    <message>
        <source>The simulated scanner has nothing to look at: %1</source>
        <translation>Der simulierte Scanner hat nichts vor sich: %1</translation>
    </message>
    <message>
        <source>The scans of this session were recorded elsewhere: no scanner belongs to it.</source>
        <translation>Die Scans dieser Sitzung wurden anderswo aufgezeichnet: Es gehört kein Scanner dazu.</translation>
    </message>
    <message>
        <source>The simulated scanner needs an object: choose one.</source>
        <translation>Der simulierte Scanner braucht ein Objekt: Wählen Sie eines.</translation>
    </message>
    <message>
        <source>You turn the table yourself: scan one view at a time, or choose automatic.</source>
        <translation>Sie drehen den Tisch selbst: Scannen Sie jeweils eine Ansicht, oder wählen Sie „Automatisch“.</translation>
    </message>
    <message>
        <source>The table is turned by hand: choose assisted.</source>
        <translation>Der Tisch wird von Hand gedreht: Wählen Sie „Begleitet“.</translation>
    </message>
    <message>
        <source>The session has begun. Tests with its devices are made before the first scan.</source>
        <translation>Die Sitzung hat begonnen. Ihre Geräte werden vor dem ersten Scan geprüft.</translation>
    </message>
    <message>
        <source>This scanner has no turntable.</source>
        <translation>Dieser Scanner hat keinen Drehtisch.</translation>
    </message>
    <message>
        <source>There is no session yet: it begins with the first scan.</source>
        <translation>Es gibt noch keine Sitzung: Sie beginnt mit dem ersten Scan.</translation>
    </message>
    <message>
        <source>The object has stood in one stand only.</source>
        <translation>Das Objekt stand nur in einer Aufstellung.</translation>
    </message>
    <message>
        <source>All stands that have views are in place.</source>
        <translation>Alle Aufstellungen mit Ansichten sind eingefügt.</translation>
    </message>
    <message>
        <source>No session is open.</source>
        <translation>Keine Sitzung ist geöffnet.</translation>
    </message>
</context>
<context>
    <name>Phrase</name>
    <message>
        <source>%1: is damaged; before anything was written to it, it was copied to %2</source>
        <translation>%1: ist beschädigt; bevor etwas hineingeschrieben wurde, wurde sie nach %2 kopiert</translation>
    </message>
    <message>
        <source>%1: the table %2 is damaged, %3 rows of it were read</source>
        <translation>%1: die Tabelle %2 ist beschädigt, %3 Zeilen davon wurden gelesen</translation>
    </message>
    <message>
        <source>%1: not all rows of %2 could be read</source>
        <translation>%1: nicht alle Zeilen von %2 konnten gelesen werden</translation>
    </message>
    <message>
        <source>%1: step %2, the last one, is lost</source>
        <translation>%1: Schritt %2, der letzte, ist verloren</translation>
    </message>
    <message>
        <source>%1: step %2 is lost</source>
        <translation>%1: Schritt %2 ist verloren</translation>
    </message>
    <message>
        <source>%1: step %2 is lost: not all of its views are there</source>
        <translation>%1: Schritt %2 ist verloren: nicht alle seine Ansichten sind vorhanden</translation>
    </message>
    <message>
        <source>%1: step %2 is lost: it names no position</source>
        <translation>%1: Schritt %2 ist verloren: er nennt keine Position</translation>
    </message>
    <message>
        <source>%1; it is made again</source>
        <translation>%1; es wird neu erzeugt</translation>
    </message>
    <message>
        <source>%1: model %2 is of other views; it is made again</source>
        <translation>%1: Modell %2 gehört zu anderen Ansichten; es wird neu erzeugt</translation>
    </message>
    <message>
        <source>%1: model %2 is of other samples; it is made again</source>
        <translation>%1: Modell %2 gehört zu anderen Messpunkten; es wird neu erzeugt</translation>
    </message>
    <message>
        <source>%1: plan %2 is of other positions</source>
        <translation>%1: Plan %2 gehört zu anderen Positionen</translation>
    </message>
    <message>
        <source>%1: step %2 was not as it was written; it was carried out again from its scans</source>
        <translation>%1: Schritt %2 war nicht so, wie er geschrieben wurde; er wurde aus seinen Scans wiederholt</translation>
    </message>
    <message>
        <source>%1: step %2 is not as it was written: do not trust its model. Go back to a step before it, or begin anew with its scans</source>
        <translation>%1: Schritt %2 ist nicht so, wie er geschrieben wurde: Vertrauen Sie seinem Modell nicht. Gehen Sie zu einem Schritt davor zurück, oder beginnen Sie mit seinen Scans neu</translation>
    </message>
    <message>
        <source>%1: %2 files of the scanner&apos;s profile are lost</source>
        <translation>%1: %2 Dateien des Scannerprofils sind verloren</translation>
    </message>
    <message>
        <source>%1: the object of the simulated scanner is not the one that was kept</source>
        <translation>%1: das Objekt des simulierten Scanners ist nicht das, das aufbewahrt wurde</translation>
    </message>
    <message>
        <source>%1: %2 more damages of this kind</source>
        <translation>%1: %2 weitere Schäden dieser Art</translation>
    </message>
    <message>
        <source>%1: %2 more of %3 are damaged</source>
        <translation>%1: %2 weitere von %3 sind beschädigt</translation>
    </message>
    <message>
        <source>%1: has very many steps; those before step %2 were not read, and stay in the file</source>
        <translation>%1: hat sehr viele Schritte; die vor Schritt %2 wurden nicht gelesen und bleiben in der Datei</translation>
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
        <translation>der Scanner hat %1 Millionen Strahlen: Das braucht etwa %2 Speicher, etwa %3 mehr mit jedem Scan, und jeder Schritt dauert</translation>
    </message>
    <message>
        <source>%1; of every scan about %2 million samples are worked on, the session keeps all</source>
        <translation>%1; von jedem Scan werden etwa %2 Millionen Messpunkte verarbeitet, die Sitzung behält alle</translation>
    </message>
    <message>
        <source>assumed</source>
        <translation>angenommen</translation>
    </message>
    <message>
        <source>told by the numbers</source>
        <translation>aus den Zahlen erkannt</translation>
    </message>
    <message>
        <source>as the file says</source>
        <translation>wie in der Datei</translation>
    </message>
    <message>
        <source>as given</source>
        <translation>wie angegeben</translation>
    </message>
    <message>
        <source>(%1, %2, %3)</source>
        <translation>(%1, %2, %3)</translation>
    </message>
    <message>
        <source>the scanner looks along %1 (%2)</source>
        <translation>der Scanner schaut entlang %1 (%2)</translation>
    </message>
    <message>
        <source>measured from one point in all directions (%1)</source>
        <translation>von einem Punkt aus in alle Richtungen gemessen (%1)</translation>
    </message>
    <message>
        <source>the columns go around an axis, like a cylinder (%1)</source>
        <translation>die Spalten laufen um eine Achse wie bei einem Zylinder (%1)</translation>
    </message>
    <message>
        <source>the rays are those of the profile</source>
        <translation>die Strahlen sind die des Profils</translation>
    </message>
    <message>
        <source>%1 cells with the value given for no sample left out</source>
        <translation>%1 Zellen mit dem Wert für „keine Messung“ weggelassen</translation>
    </message>
    <message>
        <source>%1 cells with the point (0, 0, 0) left out as no samples</source>
        <translation>%1 Zellen mit dem Punkt (0, 0, 0) als keine Messpunkte weggelassen</translation>
    </message>
    <message>
        <source>%1 cells with one and the same point left out as no samples</source>
        <translation>%1 Zellen mit ein und demselben Punkt als keine Messpunkte weggelassen</translation>
    </message>
    <message>
        <source>%1 cells at one constant depth left out as no samples</source>
        <translation>%1 Zellen in einer konstanten Tiefe als keine Messpunkte weggelassen</translation>
    </message>
    <message>
        <source>%1 cells out of all proportion left out</source>
        <translation>%1 Zellen außerhalb jeder Größenordnung weggelassen</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>the points are in the object&apos;s coordinates already, no pose is applied</source>
        <translation>die Punkte sind schon in den Koordinaten des Objekts, es wird keine Pose angewandt</translation>
    </message>
    <message>
        <source>the poses have another unit: 1 = %1 mm (%2)</source>
        <translation>die Posen haben eine andere Einheit: 1 = %1 mm (%2)</translation>
    </message>
    <message>
        <source>%1 is up</source>
        <translation>%1 ist oben</translation>
    </message>
    <message>
        <source>z is taken for up although the poses turn about %1</source>
        <translation>z gilt als oben, obwohl die Posen um %1 drehen</translation>
    </message>
    <message>
        <source>1 unit = %1 mm (%2)</source>
        <translation>1 Einheit = %1 mm (%2)</translation>
    </message>
    <message>
        <source>rows and columns are exchanged</source>
        <translation>Zeilen und Spalten sind vertauscht</translation>
    </message>
    <message>
        <source>an offset of (%1, %2, %3) mm was taken off</source>
        <translation>ein Versatz von (%1, %2, %3) mm wurde abgezogen</translation>
    </message>
    <message>
        <source>scan %1 was rejected and is not in the model: %2</source>
        <translation>Scan %1 wurde verworfen und ist nicht im Modell: %2</translation>
    </message>
    <message>
        <source>scan %1, whose table was turned by hand, is doubtful and may be off by %2 mm: %3</source>
        <translation>Scan %1, bei dem der Tisch von Hand gedreht wurde, ist zweifelhaft und kann um %2 mm daneben liegen: %3</translation>
    </message>
    <message>
        <source>scan %1 is doubtful: %2</source>
        <translation>Scan %1 ist zweifelhaft: %2</translation>
    </message>
    <message>
        <source>scan %1 waits until it is known how the object stood</source>
        <translation>Scan %1 wartet, bis bekannt ist, wie das Objekt stand</translation>
    </message>
    <message>
        <source>the model has no surface: nothing of the object was covered</source>
        <translation>das Modell hat keine Oberfläche: vom Objekt wurde nichts erfasst</translation>
    </message>
    <message>
        <source>little is covered: there are positions that would still show %1 % of what the model has</source>
        <translation>wenig ist erfasst: es gibt Positionen, die noch %1 % dessen zeigen würden, was das Modell hat</translation>
    </message>
    <message>
        <source>scan %1 fits where the table would have turned the other way: if it always does, calibrate it, or say that its sense is -1</source>
        <translation>Scan %1 passt dort, wo der Tisch andersherum gedreht hätte: Wenn er das immer tut, kalibrieren Sie ihn, oder geben Sie seinen Drehsinn als -1 an</translation>
    </message>
    <message>
        <source>stand %1 is not aligned with the others yet and is not in the model</source>
        <translation>Aufstellung %1 ist noch nicht an den anderen ausgerichtet und nicht im Modell</translation>
    </message>
    <message>
        <source>stand %1 is not in the model: %2</source>
        <translation>Aufstellung %1 ist nicht im Modell: %2</translation>
    </message>
    <message>
        <source>stand %1 is in the model although something speaks against it: %2</source>
        <translation>Aufstellung %1 ist im Modell, obwohl etwas dagegen spricht: %2</translation>
    </message>
    <message>
        <source>the acquisition is not finished. %1</source>
        <translation>die Aufnahme ist nicht abgeschlossen. %1</translation>
    </message>
    <message>
        <source>it fits if the turns go the other way, %1 times as far as listed</source>
        <translation>es passt, wenn die Drehungen andersherum gehen, %1-mal so weit wie aufgelistet</translation>
    </message>
    <message>
        <source>it fits if every turn is %1 times what the list says</source>
        <translation>es passt, wenn jede Drehung %1-mal so groß ist, wie die Liste sagt</translation>
    </message>
    <message>
        <source>%1 degrees</source>
        <translation>%1 Grad</translation>
    </message>
    <message>
        <source>%1, and as well at %2 degrees</source>
        <translation>%1, und ebenso bei %2 Grad</translation>
    </message>
    <message>
        <source>Set-up changed</source>
        <translation>Aufbau geändert</translation>
    </message>
    <message>
        <source>Scan %1 added</source>
        <translation>Scan %1 hinzugefügt</translation>
    </message>
    <message>
        <source>%1 recorded scans imported</source>
        <translation>%1 aufgezeichnete Scans importiert</translation>
    </message>
    <message>
        <source>Position %1 chosen</source>
        <translation>Position %1 gewählt</translation>
    </message>
    <message>
        <source>Proposed position taken again</source>
        <translation>Wieder die vorgeschlagene Position genommen</translation>
    </message>
    <message>
        <source>Scan %1 left out</source>
        <translation>Scan %1 weggelassen</translation>
    </message>
    <message>
        <source>Scan %1 taken back</source>
        <translation>Scan %1 wieder aufgenommen</translation>
    </message>
    <message>
        <source>Scan %1 taken as from %2 degrees</source>
        <translation>Scan %1 genommen wie bei %2 Grad</translation>
    </message>
    <message>
        <source>Opened again</source>
        <translation>Wieder geöffnet</translation>
    </message>
    <message>
        <source>Ended: %1</source>
        <translation>Beendet: %1</translation>
    </message>
    <message>
        <source>Taken over from an earlier version</source>
        <translation>Aus einer früheren Version übernommen</translation>
    </message>
    <message>
        <source>Object turned over</source>
        <translation>Objekt gewendet</translation>
    </message>
    <message>
        <source>Stand %1 placed</source>
        <translation>Aufstellung %1 platziert</translation>
    </message>
    <message>
        <source>Alignment of stand %1</source>
        <translation>Ausrichtung von Aufstellung %1</translation>
    </message>
    <message>
        <source>Pose %1 chosen for stand %2</source>
        <translation>Pose %1 für Aufstellung %2 gewählt</translation>
    </message>
    <message>
        <source>Object known by stand %1</source>
        <translation>Objekt durch Aufstellung %1 bekannt</translation>
    </message>
    <message>
        <source>Automatic from here</source>
        <translation>Ab hier automatisch</translation>
    </message>
    <message>
        <source>Assisted from here</source>
        <translation>Ab hier begleitet</translation>
    </message>
    <message>
        <source>slides along %1</source>
        <translation>gleitet entlang %1</translation>
    </message>
    <message>
        <source>turns about %1</source>
        <translation>dreht sich um %1</translation>
    </message>
    <message>
        <source>moves freely</source>
        <translation>bewegt sich frei</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 und %2</translation>
    </message>
    <message>
        <source>not registered</source>
        <translation>nicht registriert</translation>
    </message>
    <message>
        <source>the first view defines the frame</source>
        <translation>die erste Ansicht legt das Koordinatensystem fest</translation>
    </message>
    <message>
        <source>the first view is where the others go</source>
        <translation>die erste Ansicht liegt dort, wohin die anderen kommen</translation>
    </message>
    <message>
        <source>registered by an earlier version</source>
        <translation>von einer früheren Version registriert</translation>
    </message>
    <message>
        <source>%1 % of the expected overlap fits</source>
        <translation>%1 % der erwarteten Überlappung passen</translation>
    </message>
    <message>
        <source>only %1 % of the expected overlap fits</source>
        <translation>nur %1 % der erwarteten Überlappung passen</translation>
    </message>
    <message>
        <source>only %1 points overlap with the model</source>
        <translation>nur %1 Punkte überlappen mit dem Modell</translation>
    </message>
    <message>
        <source>the scanner looked through %1 % of the model&apos;s surface</source>
        <translation>der Scanner hat durch %1 % der Modelloberfläche hindurchgesehen</translation>
    </message>
    <message>
        <source>the surfaces differ %1 times as much as their noise explains</source>
        <translation>die Oberflächen weichen %1-mal so stark ab, wie ihr Rauschen erklärt</translation>
    </message>
    <message>
        <source>it moved %1 sigma away from where the mechanics put it</source>
        <translation>es hat sich %1 Sigma von dort entfernt, wohin die Mechanik es stellte</translation>
    </message>
    <message>
        <source>a pose %1 mm away fits as well</source>
        <translation>eine %1 mm entfernte Pose passt ebenso gut</translation>
    </message>
    <message>
        <source>the surface %1: that part of the pose is the mechanics&apos; word alone</source>
        <translation>die Oberfläche %1: dieser Teil der Pose beruht allein auf der Mechanik</translation>
    </message>
    <message>
        <source>the pose had not come to rest when the iterations ran out</source>
        <translation>die Pose war nicht zur Ruhe gekommen, als die Iterationen aufgebraucht waren</translation>
    </message>
    <message>
        <source>it contradicts what the other scans agree on, with %1 % of its points there</source>
        <translation>es widerspricht dem, worin die anderen Scans übereinstimmen, mit %1 % seiner Punkte dort</translation>
    </message>
    <message>
        <source>no pose was given for it, and its surface alone does not say where it belongs</source>
        <translation>es wurde keine Pose dafür angegeben, und seine Oberfläche allein sagt nicht, wohin es gehört</translation>
    </message>
    <message>
        <source>it does not fit the position that it was said to be of; it fits position %1</source>
        <translation>es passt nicht zu der Position, von der es stammen soll; es passt zu Position %1</translation>
    </message>
    <message>
        <source>it fits %1 degrees away from where the table says it is: did the table slip, or was it pushed?</source>
        <translation>es passt %1 Grad neben dem, was der Tisch meldet: Ist der Tisch gerutscht, oder wurde er angestoßen?</translation>
    </message>
    <message>
        <source>it does not fit where it was said to be taken; it fits where the table stands at %1</source>
        <translation>es passt nicht dort, wo es aufgenommen worden sein soll; es passt, wenn der Tisch bei %1 steht</translation>
    </message>
    <message>
        <source>it was taken as from %1 degrees of the table, where it fits</source>
        <translation>es wurde wie bei %1 Grad des Tisches genommen, wo es passt</translation>
    </message>
    <message>
        <source>it fits if the list has the inverse of every pose</source>
        <translation>es passt, wenn die Liste von jeder Pose die Inverse hat</translation>
    </message>
    <message>
        <source>it fits if positions in the list are taken times %1: another unit</source>
        <translation>es passt, wenn die Positionen der Liste mal %1 genommen werden: eine andere Einheit</translation>
    </message>
    <message>
        <source>it fits if the scanner&apos;s other axes than %1 point the other way</source>
        <translation>es passt, wenn die anderen Achsen des Scanners als %1 in die Gegenrichtung zeigen</translation>
    </message>
    <message>
        <source>it fits if the axis is %1 mm beside where the list has it</source>
        <translation>es passt, wenn die Achse %1 mm neben der aus der Liste liegt</translation>
    </message>
    <message>
        <source>only %1 points overlap with the model: the table alone says where it belongs</source>
        <translation>nur %1 Punkte überlappen mit dem Modell: der Tisch allein sagt, wohin es gehört</translation>
    </message>
    <message>
        <source>all scans together hold it</source>
        <translation>alle Scans zusammen halten es</translation>
    </message>
    <message>
        <source>one pose is possible, with %1 % of the surface in common</source>
        <translation>eine Pose ist möglich, mit %1 % gemeinsamer Oberfläche</translation>
    </message>
    <message>
        <source>the surfaces slide along each other</source>
        <translation>die Oberflächen gleiten aneinander entlang</translation>
    </message>
    <message>
        <source>%1 poses are possible, and all leave the same surface</source>
        <translation>%1 Posen sind möglich, und alle lassen dieselbe Oberfläche</translation>
    </message>
    <message>
        <source>%1 poses are possible</source>
        <translation>%1 Posen sind möglich</translation>
    </message>
    <message>
        <source>%1 % of the surface cannot be there in the best pose, or should have been seen and was not</source>
        <translation>%1 % der Oberfläche können in der besten Pose nicht dort sein, oder hätten gesehen werden müssen und wurden es nicht</translation>
    </message>
    <message>
        <source>only %1 % of the surface is in common</source>
        <translation>nur %1 % der Oberfläche sind gemeinsam</translation>
    </message>
    <message>
        <source>it does not fit in one piece: views moved %1 sigma away from where the mechanics put them</source>
        <translation>es passt nicht als Ganzes: Ansichten sind %1 Sigma von dort entfernt, wohin die Mechanik sie stellte</translation>
    </message>
    <message>
        <source>no pose fits</source>
        <translation>keine Pose passt</translation>
    </message>
    <message>
        <source>Erased below a plane</source>
        <translation>Unter einer Ebene gelöscht</translation>
    </message>
    <message>
        <source>Erased in a box</source>
        <translation>In einem Quader gelöscht</translation>
    </message>
    <message>
        <source>Erased in a lasso</source>
        <translation>In einem Lasso gelöscht</translation>
    </message>
    <message>
        <source>Erased pieces</source>
        <translation>Stücke gelöscht</translation>
    </message>
    <message>
        <source>Erasure %1 taken back</source>
        <translation>Löschung %1 zurückgenommen</translation>
    </message>
    <message>
        <source>it fits only scans whose own place is doubtful</source>
        <translation>es passt nur zu Scans, deren eigene Lage zweifelhaft ist</translation>
    </message>
    <message>
        <source>too little holds it to the scans that hold each other</source>
        <translation>zu wenig hält es an den Scans, die einander halten</translation>
    </message>
    <message>
        <source>the table alone says where it belongs, and the scan before it fits another turn of the table</source>
        <translation>der Tisch allein sagt, wohin es gehört, und der Scan davor passt zu einer anderen Drehung des Tisches</translation>
    </message>
</context>
<context>
    <name>PositionalSpace</name>
    <message>
        <source>per cell</source>
        <translation>je Zelle</translation>
    </message>
    <message>
        <source>P_v: void</source>
        <translation>P_v: Leerraum</translation>
    </message>
    <message>
        <source>P_s: surface already seen</source>
        <translation>P_s: schon gesehene Oberfläche</translation>
    </message>
    <message>
        <source>P_c: rays of position %1</source>
        <translation>P_c: Strahlen der Position %1</translation>
    </message>
    <message>
        <source>P_c: rays of all positions</source>
        <translation>P_c: Strahlen aller Positionen</translation>
    </message>
    <message>
        <source>positions</source>
        <translation>Positionen</translation>
    </message>
    <message>
        <source>a window at %1 around, %2 mm up: %3 %4</source>
        <translation>ein Fenster bei %1 im Umlauf, %2 mm hoch: %3 %4</translation>
    </message>
    <message>
        <source>no ranging ray leaves through it</source>
        <translation>kein Messstrahl verlässt es</translation>
    </message>
    <message>
        <source>the scanner looks through it from %1 to %2 aside</source>
        <translation>der Scanner schaut hindurch von %1 bis %2 seitlich</translation>
    </message>
    <message>
        <source>, %1 to %2 up</source>
        <translation>, %1 bis %2 nach oben</translation>
    </message>
    <message>
        <source>No plan yet to show in positional space</source>
        <translation>Noch kein Plan im Positionsraum zu zeigen</translation>
    </message>
    <message>
        <source>No positional space yet</source>
        <translation>Noch kein Positionsraum</translation>
    </message>
    <message>
        <source>in directions %1° aside, %2° up, each ± %3°</source>
        <translation>in Richtungen %1° seitlich, %2° hoch, je ± %3°</translation>
    </message>
    <message>
        <source>summed over all directions</source>
        <translation>summiert über alle Richtungen</translation>
    </message>
    <message>
        <source>Per cell</source>
        <translation>Je Zelle</translation>
    </message>
</context>
<context>
    <name>Preferences</name>
    <message>
        <source>Theme</source>
        <translation>Farbschema</translation>
    </message>
    <message>
        <source>Colours of the window and of the views.</source>
        <translation>Farben des Fensters und der Ansichten.</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>As the desktop</source>
        <translation>Wie der Desktop</translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation>Maus</translation>
    </message>
    <message>
        <source>Which program the mouse buttons in the views follow.</source>
        <translation>Welchem Programm die Maustasten in den Ansichten folgen.</translation>
    </message>
    <message>
        <source>Upright: the table stays level</source>
        <translation>Aufrecht: der Tisch bleibt waagerecht</translation>
    </message>
    <message>
        <source>Threads</source>
        <translation>Threads</translation>
    </message>
    <message>
        <source>Processors that computing may use from the next start on; 0 takes all. Results never depend on it.</source>
        <translation>Prozessoren, die die Berechnung ab dem nächsten Start nutzen darf; 0 nimmt alle. Ergebnisse hängen nie davon ab.</translation>
    </message>
    <message>
        <source>Go on where I was</source>
        <translation>Dort fortfahren, wo ich war</translation>
    </message>
    <message>
        <source>Open the session of last time at start if it was not ended.</source>
        <translation>Beim Start die Sitzung vom letzten Mal öffnen, wenn sie nicht beendet war.</translation>
    </message>
    <message>
        <source>Sound</source>
        <translation>Ton</translation>
    </message>
    <message>
        <source>Sound when scanning has ended or waits for you.</source>
        <translation>Ton, wenn das Scannen beendet ist oder auf Sie wartet.</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>Of the window, from the next start on. The command line and what is written in files stay English.</source>
        <translation>Des Fensters, ab dem nächsten Start. Die Kommandozeile und was in Dateien geschrieben wird, bleiben englisch.</translation>
    </message>
</context>
<context>
    <name>PrintText</name>
    <message>
        <source>Nothing of it is left.</source>
        <translation>Es bleibt nichts davon übrig.</translation>
    </message>
    <message numerus="yes">
        <source>It has %n opening(s), the widest %1 mm wide: close them all.</source>
        <translation>
            <numerusform>Es hat %n Öffnung, %1 mm breit: Schließen Sie sie.</numerusform>
            <numerusform>Es hat %n Öffnungen, die weiteste %1 mm breit: Schließen Sie alle.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n edge(s) have more than two triangles, or two that face opposite ways.</source>
        <translation>
            <numerusform>%n Kante hat mehr als zwei Dreiecke, oder zwei entgegengesetzt gerichtete.</numerusform>
            <numerusform>%n Kanten haben mehr als zwei Dreiecke, oder zwei entgegengesetzt gerichtete.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Surfaces only touch in %n place(s).</source>
        <translation>
            <numerusform>Oberflächen berühren sich an %n Stelle nur.</numerusform>
            <numerusform>Oberflächen berühren sich an %n Stellen nur.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n piece(s) lie inside out.</source>
        <translation>
            <numerusform>%n Stück ist umgestülpt.</numerusform>
            <numerusform>%n Stücke sind umgestülpt.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pair(s) of triangles pass through each other.</source>
        <translation>
            <numerusform>%n Paar von Dreiecken durchdringt sich.</numerusform>
            <numerusform>%n Paare von Dreiecken durchdringen sich.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>It is in %n piece(s): leave the loose ones out.</source>
        <translation>
            <numerusform>Es besteht aus %n Stück: Lassen Sie die losen weg.</numerusform>
            <numerusform>Es besteht aus %n Stücken: Lassen Sie die losen weg.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n loose piece(s) left out, %1 mm².</source>
        <translation>
            <numerusform>%n loses Stück weggelassen, %1 mm².</numerusform>
            <numerusform>%n lose Stücke weggelassen, %1 mm².</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n opening(s) closed: %1 mm² are invented, %2 mm² were measured.</source>
        <translation>
            <numerusform>%n Öffnung geschlossen: %1 mm² sind erfunden, %2 mm² wurden gemessen.</numerusform>
            <numerusform>%n Öffnungen geschlossen: %1 mm² sind erfunden, %2 mm² wurden gemessen.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n opening(s) stayed open.</source>
        <translation>
            <numerusform>%n Öffnung blieb offen.</numerusform>
            <numerusform>%n Öffnungen blieben offen.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 triangles, no farther than %2 mm from the model.</source>
        <translation>%1 Dreiecke, nicht weiter als %2 mm vom Modell entfernt.</translation>
    </message>
    <message>
        <source>Closed, %1 cm³.</source>
        <translation>Geschlossen, %1 cm³.</translation>
    </message>
    <message>
        <source>Not closed: it encloses no volume.</source>
        <translation>Nicht geschlossen: Es umschließt kein Volumen.</translation>
    </message>
</context>
<context>
    <name>Refusal</name>
    <message>
        <source>These are recorded scans without a scanner: there are no positions to scan from.</source>
        <translation>Dies sind aufgezeichnete Scans ohne Scanner: Es gibt keine Positionen zum Scannen.</translation>
    </message>
    <message>
        <source>The scanner has no position %1.</source>
        <translation>Der Scanner hat keine Position %1.</translation>
    </message>
    <message>
        <source>The object has not stood in stand %1.</source>
        <translation>Das Objekt stand nie in Aufstellung %1.</translation>
    </message>
    <message>
        <source>How the object stands in stand %1 is known already.</source>
        <translation>Wie das Objekt in Aufstellung %1 steht, ist schon bekannt.</translation>
    </message>
    <message>
        <source>Scan %1 is not part of the model.</source>
        <translation>Scan %1 gehört nicht zum Modell.</translation>
    </message>
    <message>
        <source>Scan %1 is the only view of the model.</source>
        <translation>Scan %1 ist die einzige Ansicht des Modells.</translation>
    </message>
    <message>
        <source>Scan %1 was not left out.</source>
        <translation>Scan %1 wurde nicht weggelassen.</translation>
    </message>
    <message>
        <source>Scan %1 was added before.</source>
        <translation>Scan %1 wurde schon hinzugefügt.</translation>
    </message>
    <message>
        <source>Recorded scans are imported into an empty session only.</source>
        <translation>Aufgezeichnete Scans werden nur in eine leere Sitzung importiert.</translation>
    </message>
    <message>
        <source>There is nothing to import.</source>
        <translation>Es gibt nichts zu importieren.</translation>
    </message>
    <message>
        <source>The acquisition has ended.</source>
        <translation>Die Aufnahme ist beendet.</translation>
    </message>
    <message>
        <source>The acquisition has not ended.</source>
        <translation>Die Aufnahme ist nicht beendet.</translation>
    </message>
    <message>
        <source>Nothing is proposed any more. Choose a position yourself to go on.</source>
        <translation>Es wird nichts mehr vorgeschlagen. Wählen Sie selbst eine Position, um fortzufahren.</translation>
    </message>
    <message>
        <source>The greatest number of views, %1, is taken. Allow more to go on.</source>
        <translation>Die Höchstzahl an Ansichten, %1, ist aufgenommen. Lassen Sie mehr zu, um fortzufahren.</translation>
    </message>
    <message>
        <source>Nothing has been scanned yet.</source>
        <translation>Es wurde noch nichts gescannt.</translation>
    </message>
    <message>
        <source>The object and how scans become surfaces can only be changed before the first scan.</source>
        <translation>Das Objekt und die Art, wie Scans zu Oberflächen werden, können nur vor dem ersten Scan geändert werden.</translation>
    </message>
    <message>
        <source>The settings contradict each other.</source>
        <translation>Die Einstellungen widersprechen sich.</translation>
    </message>
    <message>
        <source>What an earlier version did cannot be done again.</source>
        <translation>Was eine frühere Version getan hat, kann nicht wiederholt werden.</translation>
    </message>
    <message>
        <source>There is nothing to undo.</source>
        <translation>Es gibt nichts rückgängig zu machen.</translation>
    </message>
    <message>
        <source>There is nothing to redo.</source>
        <translation>Es gibt nichts zu wiederholen.</translation>
    </message>
    <message>
        <source>There is nothing to scan with: no scanner, or no object for the simulated one.</source>
        <translation>Es gibt nichts zum Scannen: keinen Scanner, oder kein Objekt für den simulierten.</translation>
    </message>
    <message>
        <source>Scan %1 was not found to fit another turn of the table.</source>
        <translation>Für Scan %1 wurde keine andere Drehung des Tisches gefunden, zu der er passt.</translation>
    </message>
    <message>
        <source>Stand %1 has no view yet: there is nothing to align.</source>
        <translation>Aufstellung %1 hat noch keine Ansicht: Es gibt nichts auszurichten.</translation>
    </message>
    <message>
        <source>Stand %1 has not been aligned yet.</source>
        <translation>Aufstellung %1 wurde noch nicht ausgerichtet.</translation>
    </message>
    <message>
        <source>Pose %1 is none of those that were found.</source>
        <translation>Pose %1 ist keine von denen, die gefunden wurden.</translation>
    </message>
    <message>
        <source>Something speaks against pose %1.</source>
        <translation>Etwas spricht gegen Pose %1.</translation>
    </message>
    <message>
        <source>Several stands make the object already. Undo what put them together first.</source>
        <translation>Das Objekt besteht schon aus mehreren Aufstellungen. Machen Sie zuerst rückgängig, was sie zusammengefügt hat.</translation>
    </message>
    <message>
        <source>Scan %1 is of a stand that is not the one that is worked on.</source>
        <translation>Scan %1 gehört zu einer Aufstellung, an der gerade nicht gearbeitet wird.</translation>
    </message>
    <message>
        <source>Stand %1 is not aligned with the one that is worked on.</source>
        <translation>Aufstellung %1 ist nicht an der ausgerichtet, an der gerade gearbeitet wird.</translation>
    </message>
    <message>
        <source>There is no erasure %1 to take back.</source>
        <translation>Es gibt keine Löschung %1, die zurückgenommen werden könnte.</translation>
    </message>
</context>
<context>
    <name>ReportPictures</name>
    <message>
        <source>Scan %1, position %2</source>
        <translation>Scan %1, Position %2</translation>
    </message>
    <message>
        <source>Scan %1</source>
        <translation>Scan %1</translation>
    </message>
    <message>
        <source>Stand %1</source>
        <translation>Aufstellung %1</translation>
    </message>
    <message>
        <source>Stand %1, no scan</source>
        <translation>Aufstellung %1, kein Scan</translation>
    </message>
</context>
<context>
    <name>ScannerPicture</name>
    <message>
        <source>surface</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>too steep</source>
        <translation>zu steil</translation>
    </message>
    <message>
        <source>receiver blocked</source>
        <translation>Empfänger verdeckt</translation>
    </message>
    <message>
        <source>void</source>
        <translation>Leerraum</translation>
    </message>
    <message>
        <source>inside</source>
        <translation>innen</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
</context>
<context>
    <name>SessionDigest</name>
    <message>
        <source>no scan yet</source>
        <translation>noch kein Scan</translation>
    </message>
    <message>
        <source>1 scan</source>
        <translation>1 Scan</translation>
    </message>
    <message>
        <source>%1 scans</source>
        <translation>%1 Scans</translation>
    </message>
    <message>
        <source>not ended, %1</source>
        <translation>nicht beendet, %1</translation>
    </message>
    <message>
        <source>finished, %1</source>
        <translation>abgeschlossen, %1</translation>
    </message>
    <message>
        <source>ended by you, %1</source>
        <translation>von Ihnen beendet, %1</translation>
    </message>
    <message>
        <source>imported, %1</source>
        <translation>importiert, %1</translation>
    </message>
    <message>
        <source>ended before all was seen, %1</source>
        <translation>beendet, bevor alles gesehen war, %1</translation>
    </message>
</context>
<context>
    <name>Settings</name>
    <message>
        <source>As it is</source>
        <translation>Wie sie ist</translation>
    </message>
    <message>
        <source>Fitted</source>
        <translation>Eingepasst</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Punktabstand</translation>
    </message>
    <message>
        <source>Triangle</source>
        <translation>Dreieck</translation>
    </message>
    <message>
        <source>Most views</source>
        <translation>Meiste Ansichten</translation>
    </message>
    <message>
        <source>Stop after so many views.</source>
        <translation>Nach so vielen Ansichten aufhören.</translation>
    </message>
    <message>
        <source>First position</source>
        <translation>Erste Position</translation>
    </message>
    <message>
        <source>Position of the workspace that the first scan is taken from.</source>
        <translation>Position des Arbeitsraums, von der der erste Scan aufgenommen wird.</translation>
    </message>
    <message>
        <source>Strategy</source>
        <translation>Strategie</translation>
    </message>
    <message>
        <source>How the next position is chosen: ps by positional space, uniform:N and random to compare with.</source>
        <translation>Wie die nächste Position gewählt wird: ps über den Positionsraum, uniform:N und random zum Vergleich.</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objekt</translation>
    </message>
    <message>
        <source>Mesh that the simulated scanner looks at.</source>
        <translation>Netz, das der simulierte Scanner betrachtet.</translation>
    </message>
    <message>
        <source>Place object</source>
        <translation>Objekt platzieren</translation>
    </message>
    <message>
        <source>Take the mesh where it is, or scale and centre it into the viewing volume.</source>
        <translation>Das Netz nehmen, wo es ist, oder in das Messvolumen skalieren und zentrieren.</translation>
    </message>
    <message>
        <source>Unit of the mesh</source>
        <translation>Netzeinheit</translation>
    </message>
    <message>
        <source>Millimetres in a unit of the mesh file: 10 for centimetres, 25.4 for inches, 1000 for metres.</source>
        <translation>Millimeter je Einheit der Netzdatei: 10 für Zentimeter, 25.4 für Zoll, 1000 für Meter.</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startwert</translation>
    </message>
    <message>
        <source>Seed of the simulated scanner&apos;s noise and mechanics.</source>
        <translation>Startwert für Rauschen und Mechanik des simulierten Scanners.</translation>
    </message>
    <message>
        <source>Ideal scanner</source>
        <translation>Idealer Scanner</translation>
    </message>
    <message>
        <source>Switch the simulated noise and mechanical errors off.</source>
        <translation>Simuliertes Rauschen und mechanische Fehler ausschalten.</translation>
    </message>
    <message>
        <source>Least confidence</source>
        <translation>Min. Konfidenz</translation>
    </message>
    <message>
        <source>Surface sampled at a smaller cosine than this attracts another view; 0 switches it off.</source>
        <translation>Oberfläche, die unter einem kleineren Kosinus gemessen wurde, zieht eine weitere Ansicht an; 0 schaltet es aus.</translation>
    </message>
    <message>
        <source>Least share of overlap</source>
        <translation>Kleinster Überlappungsanteil</translation>
    </message>
    <message>
        <source>A view must overlap with at least this share of the model&apos;s area per view taken.</source>
        <translation>Eine Ansicht muss mindestens mit diesem Anteil der Modellfläche je aufgenommener Ansicht überlappen.</translation>
    </message>
    <message>
        <source>Least samples of overlap</source>
        <translation>Kleinste Punktzahl der Überlappung</translation>
    </message>
    <message>
        <source>A view must overlap with at least the area of so many samples.</source>
        <translation>Eine Ansicht muss mindestens mit der Fläche so vieler Messpunkte überlappen.</translation>
    </message>
    <message>
        <source>Least overlap</source>
        <translation>Kleinste Überlappung</translation>
    </message>
    <message>
        <source>A view must overlap with the model by at least this area, in the place of share and samples.</source>
        <translation>Eine Ansicht muss mindestens mit dieser Fläche mit dem Modell überlappen, anstelle von Anteil und Punktzahl.</translation>
    </message>
    <message>
        <source>mm2</source>
        <translation>mm²</translation>
    </message>
    <message>
        <source>Rings of the border</source>
        <translation>Ringe am Rand</translation>
    </message>
    <message>
        <source>Triangles this many rings of vertices from the model&apos;s border give no pairs to register a view with.</source>
        <translation>Dreiecke so viele Eckenringe vom Rand des Modells liefern keine Paare zum Registrieren einer Ansicht.</translation>
    </message>
    <message>
        <source>Most relaxations</source>
        <translation>Höchstzahl der Lockerungen</translation>
    </message>
    <message>
        <source>So often the least overlap is halved and the pose error doubled when no position satisfies them.</source>
        <translation>So oft wird die kleinste Überlappung halbiert und der Posenfehler verdoppelt, wenn keine Position sie erfüllt.</translation>
    </message>
    <message>
        <source>By the table alone</source>
        <translation>Durch den Tisch allein</translation>
    </message>
    <message>
        <source>When nothing overlaps enough, a view that promises more than this share of the model&apos;s area is taken, placed by the table alone and called doubtful; 1: never.</source>
        <translation>Wenn nichts genug überlappt, wird eine Ansicht, die mehr als diesen Anteil der Modellfläche verspricht, aufgenommen, durch den Tisch allein platziert und als zweifelhaft bezeichnet; 1: nie.</translation>
    </message>
    <message>
        <source>Pose certainty</source>
        <translation>Sicherheit der Pose</translation>
    </message>
    <message>
        <source>The overlap of a view must fix its pose to within this many sample spacings.</source>
        <translation>Die Überlappung einer Ansicht muss ihre Pose auf so viele Punktabstände festlegen.</translation>
    </message>
    <message>
        <source>samples</source>
        <translation>Punktabstände</translation>
    </message>
    <message>
        <source>Elements of overlap</source>
        <translation>Elemente der Überlappung</translation>
    </message>
    <message>
        <source>So many surface elements predict how certain the pose of a view would be.</source>
        <translation>So viele Flächenelemente sagen voraus, wie sicher die Pose einer Ansicht wäre.</translation>
    </message>
    <message>
        <source>Pairs per observation</source>
        <translation>Paare je Beobachtung</translation>
    </message>
    <message>
        <source>Neighbouring samples share errors: so many pairs of a registration count as one observation.</source>
        <translation>Benachbarte Messpunkte teilen Fehler: So viele Paare einer Registrierung zählen als eine Beobachtung.</translation>
    </message>
    <message>
        <source>Least error of a sample</source>
        <translation>Kleinster Fehler eines Messpunkts</translation>
    </message>
    <message>
        <source>Samples are taken to be no more exact than this, whatever the scanner&apos;s profile says.</source>
        <translation>Messpunkte gelten als nicht genauer als dies, was auch immer das Profil des Scanners sagt.</translation>
    </message>
    <message>
        <source>Look ahead</source>
        <translation>Vorausschau</translation>
    </message>
    <message>
        <source>Void patches stand for the surface behind them; off, the objective is that of the paper.</source>
        <translation>Leerflächen stehen für die Oberfläche hinter ihnen; aus: die Zielfunktion ist die der Veröffentlichung.</translation>
    </message>
    <message>
        <source>Reach of the look-ahead</source>
        <translation>Reichweite der Vorausschau</translation>
    </message>
    <message>
        <source>So far ahead an open void patch stands for unseen surface.</source>
        <translation>So weit voraus steht eine offene Leerfläche für ungesehene Oberfläche.</translation>
    </message>
    <message>
        <source>Widest hole</source>
        <translation>Größtes Loch</translation>
    </message>
    <message>
        <source>Patches that face each other across no more than this bound one hole.</source>
        <translation>Leerflächen, die einander über höchstens diesen Abstand gegenüberliegen, begrenzen ein Loch.</translation>
    </message>
    <message>
        <source>Facing angle</source>
        <translation>Winkel des Gegenüberliegens</translation>
    </message>
    <message>
        <source>Patches face each other when either lies this near to where the other points.</source>
        <translation>Leerflächen liegen einander gegenüber, wenn jede so nahe dort liegt, wohin die andere zeigt.</translation>
    </message>
    <message>
        <source>deg</source>
        <translation>Grad</translation>
    </message>
    <message>
        <source>Opening angle</source>
        <translation>Öffnungswinkel</translation>
    </message>
    <message>
        <source>A view that looks farther than this from the normal of an opening hardly looks through it.</source>
        <translation>Eine Ansicht, die weiter als dies von der Normalen einer Öffnung schaut, sieht kaum hindurch.</translation>
    </message>
    <message>
        <source>Forecast surface</source>
        <translation>Oberfläche vorhersagen</translation>
    </message>
    <message>
        <source>Positions are ranked by the new surface that they are forecast to show, from a prediction of what closes the model; off, by void patches alone.</source>
        <translation>Positionen werden nach der neuen Oberfläche gereiht, die sie laut Vorhersage zeigen; diese folgt aus einer Schätzung dessen, was das Modell schließt; aus: nach Leerflächen allein.</translation>
    </message>
    <message>
        <source>Share of patches</source>
        <translation>Anteil der Leerflächen</translation>
    </message>
    <message>
        <source>In a forecast void patches count by so much of their area beside the predicted surface.</source>
        <translation>In einer Vorhersage zählen Leerflächen mit so viel ihrer Fläche neben der vorhergesagten Oberfläche.</translation>
    </message>
    <message>
        <source>Share worth a forecast</source>
        <translation>Anteil, der eine Vorhersage wert ist</translation>
    </message>
    <message>
        <source>A view must be forecast to show at least this share of the model&apos;s area.</source>
        <translation>Für eine Ansicht muss mindestens dieser Anteil der Modellfläche vorhergesagt sein.</translation>
    </message>
    <message>
        <source>Share worth a probe</source>
        <translation>Anteil, der einen Versuch wert ist</translation>
    </message>
    <message>
        <source>After a view that showed enough, a forecast of this share of the termination threshold is tried; 1 never.</source>
        <translation>Nach einer Ansicht, die genug zeigte, wird eine Vorhersage von diesem Anteil der Abbruchschwelle versucht; 1: nie.</translation>
    </message>
    <message>
        <source>Offset from the surface</source>
        <translation>Abstand von der Oberfläche</translation>
    </message>
    <message>
        <source>Lines of sight and observation rays begin this far in front of the surface.</source>
        <translation>Sichtlinien und Beobachtungsstrahlen beginnen so weit vor der Oberfläche.</translation>
    </message>
    <message>
        <source>Margin of sight</source>
        <translation>Spielraum der Sicht</translation>
    </message>
    <message>
        <source>What blocks a line of sight within this distance of either end does not count.</source>
        <translation>Was eine Sichtlinie innerhalb dieses Abstands von einem ihrer Enden verdeckt, zählt nicht.</translation>
    </message>
    <message>
        <source>Traced positions</source>
        <translation>Verfolgte Positionen</translation>
    </message>
    <message>
        <source>So many positions at a time are judged with the scanner&apos;s own rays.</source>
        <translation>So viele Positionen auf einmal werden mit den eigenen Strahlen des Scanners beurteilt.</translation>
    </message>
    <message>
        <source>Planning triangles</source>
        <translation>Dreiecke der Planung</translation>
    </message>
    <message>
        <source>So many triangles stand for the model&apos;s surface when it is projected into positional space.</source>
        <translation>So viele Dreiecke stehen für die Oberfläche des Modells, wenn sie in den Positionsraum projiziert wird.</translation>
    </message>
    <message>
        <source>Traced triangles</source>
        <translation>Verfolgte Dreiecke</translation>
    </message>
    <message>
        <source>A model of more triangles than this is decimated before rays are traced through it.</source>
        <translation>Ein Modell mit mehr Dreiecken wird vereinfacht, bevor Strahlen hindurch verfolgt werden.</translation>
    </message>
    <message>
        <source>Error of decimation</source>
        <translation>Fehler der Vereinfachung</translation>
    </message>
    <message>
        <source>The decimated model is off by no more than this.</source>
        <translation>Das vereinfachte Modell weicht höchstens um so viel ab.</translation>
    </message>
    <message>
        <source>Side of a voxel</source>
        <translation>Kantenlänge eines Voxels</translation>
    </message>
    <message>
        <source>Unseen space is divided into voxels of this side.</source>
        <translation>Ungesehener Raum wird in Voxel dieser Kantenlänge geteilt.</translation>
    </message>
    <message>
        <source>Crossing angle</source>
        <translation>Kreuzungswinkel</translation>
    </message>
    <message>
        <source>Two rays that measured nothing free what lies where they cross at no less than this angle.</source>
        <translation>Zwei Strahlen, die nichts gemessen haben, machen frei, wo sie sich unter mindestens diesem Winkel kreuzen.</translation>
    </message>
    <message>
        <source>Pull of silence</source>
        <translation>Gewicht der Stille</translation>
    </message>
    <message>
        <source>A single ray that measured nothing makes what it passed so likely to be free, beside 6 for the neighbours.</source>
        <translation>Ein einzelner Strahl, der nichts gemessen hat, macht seinen Weg so wahrscheinlich frei, neben 6 für die Nachbarn.</translation>
    </message>
    <message>
        <source>Most voxels</source>
        <translation>Höchstzahl der Voxel</translation>
    </message>
    <message>
        <source>Voxels are larger where there would be more of them.</source>
        <translation>Voxel sind größer, wo es sonst mehr davon gäbe.</translation>
    </message>
    <message>
        <source>Clear of breakdown</source>
        <translation>Abstand vom Grenzwinkel</translation>
    </message>
    <message>
        <source>A view should have sampled predicted surface that it saw this much inside the breakdown angle.</source>
        <translation>Eine Ansicht sollte vorhergesagte Oberfläche gemessen haben, die sie um so viel innerhalb des Grenzwinkels sah.</translation>
    </message>
    <message>
        <source>Sweeps</source>
        <translation>Durchläufe</translation>
    </message>
    <message>
        <source>So often the levels of unseen space are relaxed, a quarter of it after each look.</source>
        <translation>So oft werden die Werte des ungesehenen Raums gelockert, ein Viertel davon nach jedem Blick.</translation>
    </message>
    <message>
        <source>Most looks</source>
        <translation>Höchstzahl der Blicke</translation>
    </message>
    <message>
        <source>So often predicted surface that views should have sampled is carved away.</source>
        <translation>So oft wird vorhergesagte Oberfläche abgetragen, die Ansichten hätten messen müssen.</translation>
    </message>
    <message>
        <source>Views remembered</source>
        <translation>Gemerkte Ansichten</translation>
    </message>
    <message>
        <source>So many of the last views correct a forecast.</source>
        <translation>So viele der letzten Ansichten korrigieren eine Vorhersage.</translation>
    </message>
    <message>
        <source>Weight beforehand</source>
        <translation>Gewicht des Vorwissens</translation>
    </message>
    <message>
        <source>What is known beforehand of forecasts counts like a view that was forecast to show so many samples.</source>
        <translation>Das Vorwissen über Vorhersagen zählt wie eine Ansicht, für die so viele Messpunkte vorhergesagt waren.</translation>
    </message>
    <message>
        <source>Share beforehand</source>
        <translation>Anteil des Vorwissens</translation>
    </message>
    <message>
        <source>Share of what is forecast that is found, as far as is known beforehand.</source>
        <translation>Anteil des Vorhergesagten, der sich findet, soweit vorab bekannt.</translation>
    </message>
    <message>
        <source>Spread beforehand</source>
        <translation>Streuung des Vorwissens</translation>
    </message>
    <message>
        <source>Standard deviation of that share.</source>
        <translation>Standardabweichung dieses Anteils.</translation>
    </message>
    <message>
        <source>Termination threshold</source>
        <translation>Abbruchschwelle</translation>
    </message>
    <message>
        <source>A view must promise at least this area of void, in the place of edges and share.</source>
        <translation>Eine Ansicht muss mindestens diese Fläche an Leerraum versprechen, anstelle von Kanten und Anteil.</translation>
    </message>
    <message>
        <source>Edges worth a view</source>
        <translation>Kanten, die eine Ansicht wert sind</translation>
    </message>
    <message>
        <source>A view must promise what so many boundary edges of one sample spacing show.</source>
        <translation>Eine Ansicht muss versprechen, was so viele Randkanten von einem Punktabstand zeigen.</translation>
    </message>
    <message>
        <source>Share worth a view</source>
        <translation>Anteil, der eine Ansicht wert ist</translation>
    </message>
    <message>
        <source>A view must promise at least this share of the model&apos;s area.</source>
        <translation>Eine Ansicht muss mindestens diesen Anteil der Modellfläche versprechen.</translation>
    </message>
    <message>
        <source>Share always worth a view</source>
        <translation>Anteil, der immer eine Ansicht wert ist</translation>
    </message>
    <message>
        <source>A view that promises this share of the model&apos;s area is worth it, however small that is.</source>
        <translation>Eine Ansicht, die diesen Anteil der Modellfläche verspricht, ist es wert, wie klein er auch ist.</translation>
    </message>
    <message>
        <source>A view has looked at a patch when it saw it this much inside the breakdown angle.</source>
        <translation>Eine Ansicht hat eine Leerfläche angesehen, wenn sie sie um so viel innerhalb des Grenzwinkels sah.</translation>
    </message>
    <message>
        <source>After so many views that looked at it without finding surface a patch attracts no more.</source>
        <translation>Nach so vielen Ansichten, die sie ohne Fund ansahen, zieht eine Leerfläche nichts mehr an.</translation>
    </message>
    <message>
        <source>Gain of cosine</source>
        <translation>Gewinn an Kosinus</translation>
    </message>
    <message>
        <source>A patch attracts only views that see it at a cosine larger by this than any view before.</source>
        <translation>Eine Leerfläche zieht nur Ansichten an, die sie unter einem um so viel größeren Kosinus sehen als jede davor.</translation>
    </message>
    <message>
        <source>Grazing angle</source>
        <translation>Streifwinkel</translation>
    </message>
    <message>
        <source>Views count as having seen a patch up to this angle, if only too steeply to sample it.</source>
        <translation>Bis zu diesem Winkel gilt eine Leerfläche als gesehen, wenn auch zu steil zum Messen.</translation>
    </message>
    <message>
        <source>Jump factor</source>
        <translation>Sprungfaktor</translation>
    </message>
    <message>
        <source>Surface beside an edge counts as a jump when it is so many times deeper than a surface at the breakdown angle falls off.</source>
        <translation>Oberfläche neben einer Kante zählt als Sprung, wenn sie so viel Mal tiefer liegt, als eine Oberfläche am Grenzwinkel abfällt.</translation>
    </message>
    <message>
        <source>Reach of shadows</source>
        <translation>Reichweite der Schatten</translation>
    </message>
    <message>
        <source>So far beside an edge a shadow may begin that explains why nothing was sampled.</source>
        <translation>So weit neben einer Kante darf ein Schatten beginnen, der erklärt, warum nichts gemessen wurde.</translation>
    </message>
    <message>
        <source>Rings of normals</source>
        <translation>Ringe der Normalen</translation>
    </message>
    <message>
        <source>The frame of an edge uses the mean normal of so many rings of triangles; 0 takes the edge&apos;s own.</source>
        <translation>Das Bezugssystem einer Kante nutzt die mittlere Normale so vieler Dreiecksringe; 0 nimmt die der Kante.</translation>
    </message>
    <message>
        <source>Weight of a patch</source>
        <translation>Gewicht einer Leerfläche</translation>
    </message>
    <message>
        <source>A void patch counts as edge length times sample spacing, or as the area of the edge&apos;s triangle.</source>
        <translation>Eine Leerfläche zählt als Kantenlänge mal Punktabstand, oder als Fläche des Dreiecks der Kante.</translation>
    </message>
    <message>
        <source>Cut to the viewing volume</source>
        <translation>Volumen zuschneiden</translation>
    </message>
    <message>
        <source>What a scan shows of the table, and of what stands outside of the viewing volume, is not used.</source>
        <translation>Was ein Scan vom Tisch zeigt und was außerhalb des Messvolumens steht, wird nicht verwendet.</translation>
    </message>
    <message>
        <source>Margin above the table</source>
        <translation>Über dem Tisch</translation>
    </message>
    <message>
        <source>What lies lower than this above the table is not used; auto follows spacing and noise of the samples.</source>
        <translation>Was tiefer als so viel über dem Tisch liegt, wird nicht verwendet; auto folgt Abstand und Rauschen der Messpunkte.</translation>
    </message>
    <message>
        <source>Margin inside the radius</source>
        <translation>Innerer Abstand</translation>
    </message>
    <message>
        <source>The cut is so much narrower than the viewing volume.</source>
        <translation>Der Zuschnitt ist um so viel enger als das Messvolumen.</translation>
    </message>
    <message>
        <source>Drop flying samples</source>
        <translation>Ohne Flugpunkte</translation>
    </message>
    <message>
        <source>Samples that lie between front and back of an edge are not used.</source>
        <translation>Messpunkte zwischen Vorder- und Rückseite einer Kante werden nicht verwendet.</translation>
    </message>
    <message>
        <source>Jump of a flying sample</source>
        <translation>Sprung (Flugpunkt)</translation>
    </message>
    <message>
        <source>Neighbours are apart by a jump when they are farther from each other than so many times what surface at the breakdown angle explains.</source>
        <translation>Nachbarn trennt ein Sprung, wenn sie so viel Mal weiter voneinander liegen, als Oberfläche am Grenzwinkel erklärt.</translation>
    </message>
    <message>
        <source>Drop isolated samples</source>
        <translation>Ohne Einzelpunkte</translation>
    </message>
    <message>
        <source>Samples that no neighbour belongs to are not used.</source>
        <translation>Messpunkte, zu denen kein Nachbar gehört, werden nicht verwendet.</translation>
    </message>
    <message>
        <source>Smallest piece of a scan</source>
        <translation>Kleinstes Stück</translation>
    </message>
    <message>
        <source>Pieces of a scan of fewer samples are not used.</source>
        <translation>Stücke eines Scans mit weniger Messpunkten werden nicht verwendet.</translation>
    </message>
    <message>
        <source>Spacing worked with</source>
        <translation>Arbeitsabstand</translation>
    </message>
    <message>
        <source>Samples nearer to each other than this are thinned by whole rows and columns, in what is worked on and not in what is kept; 0: none are; auto: those of a scanner with more than 1.5 million rays.</source>
        <translation>Liegen Messpunkte näher beieinander, werden sie in der Verarbeitung um ganze Zeilen und Spalten ausgedünnt, nicht im Gespeicherten; 0: nie; auto: bei einem Scanner mit mehr als 1,5 Millionen Strahlen.</translation>
    </message>
    <message>
        <source>Slack of the breakdown angle</source>
        <translation>Spielraum des Grenzwinkels</translation>
    </message>
    <message>
        <source>How much farther than the breakdown angle noise may tilt a single triangle.</source>
        <translation>So viel weiter als der Grenzwinkel darf Rauschen ein einzelnes Dreieck kippen.</translation>
    </message>
    <message>
        <source>Discontinuity factor</source>
        <translation>Unstetigkeitsfaktor</translation>
    </message>
    <message>
        <source>An edge is a jump in depth when it is so many times longer than that of a surface at the breakdown angle.</source>
        <translation>Eine Kante ist ein Tiefensprung, wenn sie so viel Mal länger ist als die einer Oberfläche am Grenzwinkel.</translation>
    </message>
    <message>
        <source>Coarse gate</source>
        <translation>Grobe Paarschranke</translation>
    </message>
    <message>
        <source>Largest distance of a pair at the beginning; auto follows the size of what a scan shows.</source>
        <translation>Größter Abstand eines Paares zu Beginn; auto folgt der Größe dessen, was ein Scan zeigt.</translation>
    </message>
    <message>
        <source>Final gate</source>
        <translation>Endgültige Paarschranke</translation>
    </message>
    <message>
        <source>Largest distance of a pair at the end; auto follows spacing and noise of the samples.</source>
        <translation>Größter Abstand eines Paares am Ende; auto folgt Abstand und Rauschen der Messpunkte.</translation>
    </message>
    <message>
        <source>Coarse angle</source>
        <translation>Grober Winkel</translation>
    </message>
    <message>
        <source>Largest angle between the normals of a pair at the beginning.</source>
        <translation>Größter Winkel zwischen den Normalen eines Paares zu Beginn.</translation>
    </message>
    <message>
        <source>Final angle</source>
        <translation>Endgültiger Winkel</translation>
    </message>
    <message>
        <source>Largest angle between the normals of a pair at the end.</source>
        <translation>Größter Winkel zwischen den Normalen eines Paares am Ende.</translation>
    </message>
    <message>
        <source>Hidden depth</source>
        <translation>Verdeckungstiefe</translation>
    </message>
    <message>
        <source>Model surface farther behind the view&apos;s counts as hidden; auto follows the size of what a scan shows.</source>
        <translation>Modelloberfläche weiter hinter der der Ansicht gilt als verdeckt; auto folgt der Größe dessen, was ein Scan zeigt.</translation>
    </message>
    <message>
        <source>Coarse points</source>
        <translation>Grobe Punkte</translation>
    </message>
    <message>
        <source>Points of the model that are looked up until the pose settles.</source>
        <translation>Punkte des Modells, die nachgeschlagen werden, bis die Pose zur Ruhe kommt.</translation>
    </message>
    <message>
        <source>Fine points</source>
        <translation>Feine Punkte</translation>
    </message>
    <message>
        <source>Points of the model that are looked up in the last rounds.</source>
        <translation>Punkte des Modells, die in den letzten Runden nachgeschlagen werden.</translation>
    </message>
    <message>
        <source>Most rounds</source>
        <translation>Höchstzahl der Runden</translation>
    </message>
    <message>
        <source>Rounds after which a registration is given up.</source>
        <translation>Runden, nach denen eine Registrierung aufgegeben wird.</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>The pose has settled when points move less than this.</source>
        <translation>Die Pose ist zur Ruhe gekommen, wenn sich Punkte weniger als so viel bewegen.</translation>
    </message>
    <message>
        <source>Search for rivals</source>
        <translation>Nach Rivalen suchen</translation>
    </message>
    <message>
        <source>Look for other poses that fit as well, as repetitive shapes have them.</source>
        <translation>Nach anderen Posen suchen, die ebenso gut passen, wie es bei sich wiederholenden Formen vorkommt.</translation>
    </message>
    <message>
        <source>Least pairs</source>
        <translation>Kleinste Zahl der Paare</translation>
    </message>
    <message>
        <source>With fewer pairs a registration has failed.</source>
        <translation>Mit weniger Paaren ist eine Registrierung gescheitert.</translation>
    </message>
    <message>
        <source>Few pairs</source>
        <translation>Wenige Paare</translation>
    </message>
    <message>
        <source>With fewer pairs a registration is doubtful.</source>
        <translation>Mit weniger Paaren ist eine Registrierung zweifelhaft.</translation>
    </message>
    <message>
        <source>Least share of inliers</source>
        <translation>Kleinster Anteil passender Paare</translation>
    </message>
    <message>
        <source>With less of the expected overlap a registration has failed.</source>
        <translation>Mit weniger der erwarteten Überlappung ist eine Registrierung gescheitert.</translation>
    </message>
    <message>
        <source>Low share of inliers</source>
        <translation>Geringer Anteil passender Paare</translation>
    </message>
    <message>
        <source>With less of the expected overlap a registration is doubtful.</source>
        <translation>Mit weniger der erwarteten Überlappung ist eine Registrierung zweifelhaft.</translation>
    </message>
    <message>
        <source>Doubtful conflicts</source>
        <translation>Zweifelhafte Widersprüche</translation>
    </message>
    <message>
        <source>With a larger share of points that the scanner looked through a registration is doubtful.</source>
        <translation>Mit einem größeren Anteil von Punkten, durch die der Scanner hindurchsah, ist eine Registrierung zweifelhaft.</translation>
    </message>
    <message>
        <source>Most conflicts</source>
        <translation>Meiste Widersprüche</translation>
    </message>
    <message>
        <source>With a larger share of points that the scanner looked through a registration has failed.</source>
        <translation>Mit einem größeren Anteil von Punkten, durch die der Scanner hindurchsah, ist eine Registrierung gescheitert.</translation>
    </message>
    <message>
        <source>Doubtful residual</source>
        <translation>Zweifelhaftes Residuum</translation>
    </message>
    <message>
        <source>With a residual of more than so many times what noise and spacing explain a registration is doubtful.</source>
        <translation>Mit einem Residuum von mehr als so viel Mal dem, was Rauschen und Abstand erklären, ist eine Registrierung zweifelhaft.</translation>
    </message>
    <message>
        <source>Largest residual</source>
        <translation>Größtes Residuum</translation>
    </message>
    <message>
        <source>With a residual of more than so many times what noise and spacing explain a registration has failed.</source>
        <translation>Mit einem Residuum von mehr als so viel Mal dem, was Rauschen und Abstand erklären, ist eine Registrierung gescheitert.</translation>
    </message>
    <message>
        <source>Doubtful motion</source>
        <translation>Zweifelhafte Bewegung</translation>
    </message>
    <message>
        <source>Farther from the start pose than so many sigmas of the prior a registration is doubtful.</source>
        <translation>Weiter als so viele Sigma der Vorgabe von der Startpose ist eine Registrierung zweifelhaft.</translation>
    </message>
    <message>
        <source>Largest motion</source>
        <translation>Größte Bewegung</translation>
    </message>
    <message>
        <source>Farther from the start pose than so many sigmas of the prior a registration has failed.</source>
        <translation>Weiter als so viele Sigma der Vorgabe von der Startpose ist eine Registrierung gescheitert.</translation>
    </message>
    <message>
        <source>Tolerance of held scans</source>
        <translation>Toleranz gehaltener Scans</translation>
    </message>
    <message>
        <source>Where the mechanics alone hold a motion of a scan, it has failed when conflicts or residual exceed so many times what is doubtful.</source>
        <translation>Wo die Mechanik allein eine Bewegung eines Scans hält, ist er gescheitert, wenn Widersprüche oder Residuum so viel Mal das Zweifelhafte überschreiten.</translation>
    </message>
    <message>
        <source>Largest pose sigma</source>
        <translation>Größtes Sigma der Pose</translation>
    </message>
    <message>
        <source>With a less certain pose, going by the pairs alone, a registration is doubtful; auto follows the spacing.</source>
        <translation>Mit einer weniger sicheren Pose, allein nach den Paaren, ist eine Registrierung zweifelhaft; auto folgt dem Punktabstand.</translation>
    </message>
    <message>
        <source>Largest distance of a pair at the beginning; auto follows the final gate.</source>
        <translation>Größter Abstand eines Paares zu Beginn; auto folgt der endgültigen Paarschranke.</translation>
    </message>
    <message>
        <source>Largest angle</source>
        <translation>Größter Winkel</translation>
    </message>
    <message>
        <source>Largest angle between the normals of a pair.</source>
        <translation>Größter Winkel zwischen den Normalen eines Paares.</translation>
    </message>
    <message>
        <source>Surface farther behind another view&apos;s counts as hidden; auto follows the size of what a scan shows.</source>
        <translation>Oberfläche weiter hinter der einer anderen Ansicht gilt als verdeckt; auto folgt der Größe dessen, was ein Scan zeigt.</translation>
    </message>
    <message>
        <source>Share of a view&apos;s points that must meet another view for the two to be tied.</source>
        <translation>Anteil der Punkte einer Ansicht, der eine andere treffen muss, damit beide verbunden werden.</translation>
    </message>
    <message>
        <source>Points that are looked up per round until the poses settle.</source>
        <translation>Punkte, die je Runde nachgeschlagen werden, bis die Posen zur Ruhe kommen.</translation>
    </message>
    <message>
        <source>Points that are looked up in the last rounds.</source>
        <translation>Punkte, die in den letzten Runden nachgeschlagen werden.</translation>
    </message>
    <message>
        <source>Least points</source>
        <translation>Kleinste Punktzahl</translation>
    </message>
    <message>
        <source>Points that each direction of a pair of views gets at least.</source>
        <translation>Punkte, die jede Richtung eines Paares von Ansichten mindestens bekommt.</translation>
    </message>
    <message>
        <source>Rounds after which the refinement is given up.</source>
        <translation>Runden, nach denen die Verfeinerung aufgegeben wird.</translation>
    </message>
    <message>
        <source>The poses have settled when points move less than this.</source>
        <translation>Die Posen sind zur Ruhe gekommen, wenn sich Punkte weniger als so viel bewegen.</translation>
    </message>
    <message>
        <source>Points per view</source>
        <translation>Punkte je Ansicht</translation>
    </message>
    <message>
        <source>Points of every placed view that the next recorded scan is registered against.</source>
        <translation>Punkte jeder platzierten Ansicht, gegen die der nächste aufgezeichnete Scan registriert wird.</translation>
    </message>
    <message>
        <source>Points that are looked up in the last rounds of the registration of a recorded scan.</source>
        <translation>Punkte, die in den letzten Runden der Registrierung eines aufgezeichneten Scans nachgeschlagen werden.</translation>
    </message>
    <message>
        <source>Surface tolerance</source>
        <translation>Oberflächentoleranz</translation>
    </message>
    <message>
        <source>Two surfaces that face the same way and are no farther apart than this are one.</source>
        <translation>Zwei Oberflächen, die gleich gerichtet und nicht weiter als dies voneinander entfernt sind, sind eine.</translation>
    </message>
    <message>
        <source>Spacing tolerance</source>
        <translation>Abstandstoleranz</translation>
    </message>
    <message>
        <source>Two surfaces are also one when they are no farther apart than so many sample spacings of the new view.</source>
        <translation>Zwei Oberflächen sind auch eine, wenn sie nicht weiter als so viele Punktabstände der neuen Ansicht auseinander liegen.</translation>
    </message>
    <message>
        <source>Normal tolerance</source>
        <translation>Normalentoleranz</translation>
    </message>
    <message>
        <source>Two surfaces face the same way when their normals enclose no more than this.</source>
        <translation>Zwei Oberflächen sind gleich gerichtet, wenn ihre Normalen höchstens diesen Winkel einschließen.</translation>
    </message>
    <message>
        <source>Steepest surface</source>
        <translation>Steilste Oberfläche</translation>
    </message>
    <message>
        <source>Surface that leans farther than this from the new view&apos;s rays is not compared with it.</source>
        <translation>Oberfläche, die stärker gegen die Strahlen der neuen Ansicht geneigt ist, wird nicht damit verglichen.</translation>
    </message>
    <message>
        <source>Margin of confidence</source>
        <translation>Vorsprung der Konfidenz</translation>
    </message>
    <message>
        <source>The new view&apos;s confidence must exceed the model&apos;s by this for its surface to replace the model&apos;s.</source>
        <translation>Die Konfidenz der neuen Ansicht muss die des Modells um so viel übertreffen, damit ihre Oberfläche die des Modells ersetzt.</translation>
    </message>
    <message>
        <source>Clearance of the seam</source>
        <translation>Abstand der Naht</translation>
    </message>
    <message>
        <source>Samples of the new view nearer than this to the model&apos;s border are left out of the seam.</source>
        <translation>Messpunkte der neuen Ansicht, die näher am Rand des Modells liegen, bleiben aus der Naht heraus.</translation>
    </message>
    <message>
        <source>A seam edge so many times longer than that of a surface at the breakdown angle is a gap.</source>
        <translation>Eine Nahtkante, die so viel Mal länger ist als die einer Oberfläche am Grenzwinkel, ist eine Lücke.</translation>
    </message>
    <message>
        <source>Shortest edge</source>
        <translation>Kürzeste Kante</translation>
    </message>
    <message>
        <source>Edges at the seam that are shorter than this are collapsed.</source>
        <translation>Kürzere Kanten an der Naht werden zusammengezogen.</translation>
    </message>
    <message>
        <source>Edges of a hole</source>
        <translation>Kanten eines Lochs</translation>
    </message>
    <message>
        <source>Holes with no more edges than this are closed where the views have seen surface.</source>
        <translation>Löcher mit höchstens so vielen Kanten werden geschlossen, wo die Ansichten Oberfläche gesehen haben.</translation>
    </message>
    <message>
        <source>Chord of a hole</source>
        <translation>Sehne eines Lochs</translation>
    </message>
    <message>
        <source>Holes are closed when that takes no edge longer than this.</source>
        <translation>Löcher werden geschlossen, wenn dazu keine längere Kante nötig ist.</translation>
    </message>
    <message>
        <source>Smallest piece</source>
        <translation>Kleinstes Stück</translation>
    </message>
    <message>
        <source>Pieces of fewer triangles are dropped.</source>
        <translation>Stücke mit weniger Dreiecken werden verworfen.</translation>
    </message>
    <message>
        <source>Mend</source>
        <translation>Ausbessern</translation>
    </message>
    <message>
        <source>Openings of a model of recorded scans are closed where a view has measured surface, and crumbs go.</source>
        <translation>Öffnungen eines Modells aus aufgezeichneten Scans werden geschlossen, wo eine Ansicht Oberfläche gemessen hat, und Krümel verschwinden.</translation>
    </message>
    <message>
        <source>Largest offset</source>
        <translation>Größter Versatz</translation>
    </message>
    <message>
        <source>A view&apos;s surface farther than this along a vertex&apos;s normal is another surface.</source>
        <translation>Die Oberfläche einer Ansicht, die entlang der Normalen eines Eckpunkts weiter entfernt ist, ist eine andere.</translation>
    </message>
    <message>
        <source>Offset in spacings</source>
        <translation>Versatz in Punktabständen</translation>
    </message>
    <message>
        <source>A view&apos;s surface within so many of its sample spacings is never another surface.</source>
        <translation>Die Oberfläche einer Ansicht innerhalb so vieler ihrer Punktabstände ist nie eine andere.</translation>
    </message>
    <message>
        <source>A view has no say when the normals enclose more than this.</source>
        <translation>Eine Ansicht zählt nicht mit, wenn die Normalen mehr als dies einschließen.</translation>
    </message>
    <message>
        <source>Passes</source>
        <translation>Durchgänge</translation>
    </message>
    <message>
        <source>How often the vertices are moved.</source>
        <translation>Wie oft die Eckpunkte verschoben werden.</translation>
    </message>
    <message>
        <source>Acquisition</source>
        <translation>Aufnahme</translation>
    </message>
    <message>
        <source>Simulated scanner</source>
        <translation>Simulierter Scanner</translation>
    </message>
    <message>
        <source>Planning</source>
        <translation>Planung</translation>
    </message>
    <message>
        <source>Predicted surface</source>
        <translation>Vorhergesagte Oberfläche</translation>
    </message>
    <message>
        <source>Ledger of forecasts</source>
        <translation>Bilanz der Vorhersagen</translation>
    </message>
    <message>
        <source>Termination</source>
        <translation>Abbruch</translation>
    </message>
    <message>
        <source>What views have looked at</source>
        <translation>Was Ansichten angesehen haben</translation>
    </message>
    <message>
        <source>Void patches</source>
        <translation>Leerflächen</translation>
    </message>
    <message>
        <source>What is not the object</source>
        <translation>Was nicht zum Objekt gehört</translation>
    </message>
    <message>
        <source>Surface of a scan</source>
        <translation>Oberfläche eines Scans</translation>
    </message>
    <message>
        <source>Registration</source>
        <translation>Registrierung</translation>
    </message>
    <message>
        <source>Verdict on a registration</source>
        <translation>Urteil über eine Registrierung</translation>
    </message>
    <message>
        <source>Refinement of all poses</source>
        <translation>Verfeinerung aller Posen</translation>
    </message>
    <message>
        <source>Import of recorded scans</source>
        <translation>Import aufgezeichneter Scans</translation>
    </message>
    <message>
        <source>Integration</source>
        <translation>Integration</translation>
    </message>
    <message>
        <source>Consensus</source>
        <translation>Konsens</translation>
    </message>
</context>
<context>
    <name>StandPoses</name>
    <message>
        <source>the evidence decided</source>
        <translation>die Indizien haben entschieden</translation>
    </message>
    <message>
        <source>you chose the pose</source>
        <translation>Sie haben die Pose gewählt</translation>
    </message>
    <message>
        <source>you use the pose although something speaks against it; the report says so</source>
        <translation>Sie verwenden die Pose, obwohl etwas dagegen spricht; der Bericht sagt es</translation>
    </message>
    <message>
        <source>Pick the same points on both, or scan more of this stand.</source>
        <translation>Wählen Sie auf beiden dieselben Punkte, oder scannen Sie mehr von dieser Aufstellung.</translation>
    </message>
    <message>
        <source>Look at the poses, pick the same points on both, or scan more of this stand.</source>
        <translation>Sehen Sie sich die Posen an, wählen Sie auf beiden dieselben Punkte, oder scannen Sie mehr von dieser Aufstellung.</translation>
    </message>
    <message>
        <source>It makes no difference which of them you use.</source>
        <translation>Es ist gleich, welche davon Sie verwenden.</translation>
    </message>
    <message>
        <source>Use the pose if the motion does not matter, or scan a stand that shows more.</source>
        <translation>Verwenden Sie die Pose, wenn es auf die Bewegung nicht ankommt, oder scannen Sie eine Aufstellung, die mehr zeigt.</translation>
    </message>
    <message>
        <source>Look at them and use the right one, or scan more.</source>
        <translation>Sehen Sie sie an und verwenden Sie die richtige, oder scannen Sie mehr.</translation>
    </message>
    <message>
        <source>Stand %1 is in place.</source>
        <translation>Aufstellung %1 ist eingefügt.</translation>
    </message>
    <message>
        <source>Stand %1 has not been aligned yet: look for poses, or pick the same points on both.</source>
        <translation>Aufstellung %1 wurde noch nicht ausgerichtet: Suchen Sie nach Posen, oder wählen Sie auf beiden dieselben Punkte.</translation>
    </message>
    <message>
        <source>Stand %1 is in place: %2, %3.</source>
        <translation>Aufstellung %1 ist eingefügt: %2, %3.</translation>
    </message>
    <message>
        <source>Stand %1 is not in place: %2. %3</source>
        <translation>Aufstellung %1 ist nicht eingefügt: %2. %3</translation>
    </message>
    <message>
        <source>Pose %1, possible</source>
        <translation>Pose %1, möglich</translation>
    </message>
    <message>
        <source>Pose %1, unlikely</source>
        <translation>Pose %1, unwahrscheinlich</translation>
    </message>
    <message>
        <source>%1 % in common, %2 mm apart
%3 % contradicted
%4 % expected, not seen</source>
        <translation>%1 % gemeinsam, %2 mm Abstand
%3 % widerlegt
%4 % erwartet, nicht gesehen</translation>
    </message>
</context>
<context>
    <name>Stands</name>
    <message>
        <source>reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>aligned</source>
        <translation>ausgerichtet</translation>
    </message>
    <message>
        <source>doubtful</source>
        <translation>zweifelhaft</translation>
    </message>
    <message>
        <source>used all the same</source>
        <translation>trotzdem verwendet</translation>
    </message>
    <message>
        <source>not aligned</source>
        <translation>nicht ausgerichtet</translation>
    </message>
    <message>
        <source>Stand %1 is aligned: %2.</source>
        <translation>Aufstellung %1 ist ausgerichtet: %2.</translation>
    </message>
    <message>
        <source>Stand %1 is not aligned, the scans leave it open: %2.</source>
        <translation>Aufstellung %1 ist nicht ausgerichtet, die Scans lassen es offen: %2.</translation>
    </message>
    <message>
        <source>Stand %1 could not be aligned: %2.</source>
        <translation>Aufstellung %1 konnte nicht ausgerichtet werden: %2.</translation>
    </message>
    <message>
        <source>Stand %1 is the reference: the object stands in the model as it stood here.</source>
        <translation>Aufstellung %1 ist die Referenz: Das Objekt steht im Modell so, wie es hier stand.</translation>
    </message>
    <message>
        <source>Stand %1 is where the operator placed it.</source>
        <translation>Aufstellung %1 ist dort, wo der Bediener sie platziert hat.</translation>
    </message>
    <message>
        <source>Stand %1 is in the model by a pose that was chosen: %2.</source>
        <translation>Aufstellung %1 ist durch eine gewählte Pose im Modell: %2.</translation>
    </message>
    <message>
        <source>Stand %1 is in the model although something speaks against it: %2.</source>
        <translation>Aufstellung %1 ist im Modell, obwohl etwas dagegen spricht: %2.</translation>
    </message>
    <message>
        <source>Stand %1 is a model of its own: it is not put together with the object yet.</source>
        <translation>Aufstellung %1 ist ein eigenes Modell: Sie ist noch nicht mit dem Objekt zusammengefügt.</translation>
    </message>
    <message>
        <source>Stand %1, not put together with the object yet</source>
        <translation>Aufstellung %1, noch nicht mit dem Objekt zusammengefügt</translation>
    </message>
    <message>
        <source>Stand %1 is not in it: it is not put together with the object.</source>
        <translation>Aufstellung %1 ist nicht darin: Sie ist nicht mit dem Objekt zusammengefügt.</translation>
    </message>
    <message>
        <source>Stands %1 are not in it: they are not put together with the object.</source>
        <translation>Die Aufstellungen %1 sind nicht darin: Sie sind nicht mit dem Objekt zusammengefügt.</translation>
    </message>
</context>
<context>
    <name>TestScanBox</name>
    <message>
        <source>Table</source>
        <translation>Tisch</translation>
    </message>
    <message>
        <source>Outside of the volume</source>
        <translation>Außerhalb des Volumens</translation>
    </message>
    <message>
        <source>Flying samples</source>
        <translation>Fliegende Messpunkte</translation>
    </message>
    <message>
        <source>Isolated samples</source>
        <translation>Einzelne Messpunkte</translation>
    </message>
    <message>
        <source>Small pieces</source>
        <translation>Kleine Stücke</translation>
    </message>
    <message>
        <source>Used</source>
        <translation>Verwendet</translation>
    </message>
    <message>
        <source>Without a sample</source>
        <translation>Ohne Messpunkt</translation>
    </message>
</context>
<context>
    <name>TimeLine</name>
    <message>
        <source>Scan %1 · position %2
did not fit</source>
        <translation>Scan %1 · Position %2
passte nicht</translation>
    </message>
    <message>
        <source>Scan %1 · position %2
+%3</source>
        <translation>Scan %1 · Position %2
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
        <translation>%1 (entlang x %2, y %3, z %4)</translation>
    </message>
    <message>
        <source>The plane cuts nothing.</source>
        <translation>Die Ebene schneidet nichts.</translation>
    </message>
    <message>
        <source>The outline is open, %1 long.</source>
        <translation>Der Umriss ist offen, %1 lang.</translation>
    </message>
    <message>
        <source>The outline is closed, %1 long, and encloses %2 mm².</source>
        <translation>Der Umriss ist geschlossen, %1 lang, und umschließt %2 mm².</translation>
    </message>
    <message>
        <source>Clipped: shown is what has %1</source>
        <translation>Geschnitten: Gezeigt wird, was bei %1 liegt</translation>
    </message>
    <message>
        <source>As a wireframe</source>
        <translation>Als Drahtgitter</translation>
    </message>
    <message>
        <source>As points</source>
        <translation>Als Punkte</translation>
    </message>
    <message>
        <source>Back faces are red</source>
        <translation>Rückseiten sind rot</translation>
    </message>
    <message>
        <source>In parallel projection</source>
        <translation>In Parallelprojektion</translation>
    </message>
    <message>
        <source>1 to 2: %1</source>
        <translation>1 bis 2: %1</translation>
    </message>
    <message>
        <source>Place %1: click the surface, or Enter takes the middle of the view</source>
        <translation>Stelle %1: Klicken Sie auf die Oberfläche, oder nehmen Sie mit der Eingabetaste die Mitte der Ansicht</translation>
    </message>
</context>
<context>
    <name>WhyCard</name>
    <message>
        <source>Your choice: the next scan is taken from here. </source>
        <translation>Ihre Wahl: Der nächste Scan wird von hier aufgenommen. </translation>
    </message>
    <message>
        <source>Next, as the scan before did not fit: this one overlaps the model clearly more. </source>
        <translation>Die nächste, da der Scan davor nicht passte: Diese überlappt deutlich mehr mit dem Modell. </translation>
    </message>
    <message>
        <source>The acquisition has ended; if it went on, this would be next. </source>
        <translation>Die Aufnahme ist beendet; ginge sie weiter, käme diese als Nächste. </translation>
    </message>
    <message>
        <source>A scan from here did not fit. </source>
        <translation>Ein Scan von hier passte nicht. </translation>
    </message>
    <message>
        <source>It shows the most unseen surface. Nothing that is left overlaps the model enough to register with it: the table alone will say where this scan belongs.</source>
        <translation>Sie zeigt am meisten ungesehene Oberfläche. Nichts, was übrig ist, überlappt genug mit dem Modell, um registriert zu werden: Der Tisch allein wird sagen, wohin dieser Scan gehört.</translation>
    </message>
    <message>
        <source>Proposed: of all positions that overlap the model enough it shows the most unseen surface.</source>
        <translation>Vorgeschlagen: Von allen Positionen, die genug mit dem Modell überlappen, zeigt diese am meisten ungesehene Oberfläche.</translation>
    </message>
    <message>
        <source>Of all positions that overlap the model enough it shows the most unseen surface; after a scan that did not fit another one comes next.</source>
        <translation>Von allen Positionen, die genug mit dem Modell überlappen, zeigt diese am meisten ungesehene Oberfläche; nach einem Scan, der nicht passte, kommt eine andere als Nächste.</translation>
    </message>
    <message>
        <source>Allowed, but the proposed position shows more.</source>
        <translation>Erlaubt, aber die vorgeschlagene Position zeigt mehr.</translation>
    </message>
    <message>
        <source>Allowed.</source>
        <translation>Erlaubt.</translation>
    </message>
    <message>
        <source>Rejected: what it would show is %1 short of the least that is worth a scan.</source>
        <translation>Abgelehnt: Was sie zeigen würde, liegt um %1 unter dem Mindesten, das einen Scan wert ist.</translation>
    </message>
    <message>
        <source> It overlaps the model too little to be registered, too.</source>
        <translation> Sie überlappt auch zu wenig mit dem Modell, um registriert zu werden.</translation>
    </message>
    <message>
        <source>Rejected: the overlap with the model is short by %1, so the scan could not be registered.</source>
        <translation>Abgelehnt: Die Überlappung mit dem Modell ist um %1 zu klein, der Scan könnte nicht registriert werden.</translation>
    </message>
    <message>
        <source>Rejected: registration would be uncertain, by %1 mm more than allowed.</source>
        <translation>Abgelehnt: Die Registrierung wäre unsicher, um %1 mm mehr als erlaubt.</translation>
    </message>
    <message>
        <source>New surface, as forecast (o_v)</source>
        <translation>Neue Oberfläche laut Vorhersage (o_v)</translation>
    </message>
    <message>
        <source>Would show (void, o_v)</source>
        <translation>Würde zeigen (Leerraum, o_v)</translation>
    </message>
    <message>
        <source>less than F = %1: a probe, as the last scan showed more</source>
        <translation>weniger als F = %1: ein Versuch, da der letzte Scan mehr zeigte</translation>
    </message>
    <message>
        <source>more than F = %1 is worth a scan</source>
        <translation>mehr als F = %1 ist einen Scan wert</translation>
    </message>
    <message>
        <source>by positional space</source>
        <translation>nach dem Positionsraum</translation>
    </message>
    <message>
        <source>before following the scanner&apos;s rays</source>
        <translation>vor dem Verfolgen der Scannerstrahlen</translation>
    </message>
    <message>
        <source>Rank</source>
        <translation>Rang</translation>
    </message>
    <message>
        <source>by what positions promise, ruled out or not</source>
        <translation>nach dem, was Positionen versprechen, ausgeschlossen oder nicht</translation>
    </message>
    <message>
        <source>Overlap (o_s)</source>
        <translation>Überlappung (o_s)</translation>
    </message>
    <message>
        <source>too little to register with</source>
        <translation>zu wenig zum Registrieren</translation>
    </message>
    <message>
        <source>more than t = %1 is needed</source>
        <translation>mehr als t = %1 ist nötig</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>unbounded</source>
        <translation>unbegrenzt</translation>
    </message>
    <message>
        <source>Registration error</source>
        <translation>Registrierungsfehler</translation>
    </message>
    <message>
        <source>weakest: %1</source>
        <translation>am schwächsten: %1</translation>
    </message>
    <message>
        <source>Unseen edges it wins</source>
        <translation>Gewonnene ungesehene Ränder</translation>
    </message>
    <message>
        <source>1 edge</source>
        <translation>1 Rand</translation>
    </message>
    <message>
        <source>%1 edges</source>
        <translation>%1 Ränder</translation>
    </message>
    <message>
        <source>in sight</source>
        <translation>in Sicht</translation>
    </message>
    <message>
        <source>light blocked by the object</source>
        <translation>Licht durch das Objekt verdeckt</translation>
    </message>
    <message>
        <source>receiver blocked by the object</source>
        <translation>Empfänger durch das Objekt verdeckt</translation>
    </message>
    <message>
        <source>too steep</source>
        <translation>zu steil</translation>
    </message>
    <message>
        <source>outside the sampling area</source>
        <translation>außerhalb des Messbereichs</translation>
    </message>
    <message>
        <source>No other position is allowed.</source>
        <translation>Keine andere Position ist erlaubt.</translation>
    </message>
    <message>
        <source>The runner-up, position %1,</source>
        <translation>Die zweitbeste, Position %1,</translation>
    </message>
    <message>
        <source>The proposed position %1</source>
        <translation>Die vorgeschlagene Position %1</translation>
    </message>
    <message>
        <source>Position %1, which the plan had proposed,</source>
        <translation>Position %1, die der Plan vorgeschlagen hatte,</translation>
    </message>
    <message>
        <source>%1 shows %2 and overlaps %3.</source>
        <translation>%1 zeigt %2 und überlappt %3.</translation>
    </message>
    <message>
        <source>more</source>
        <translation>mehr</translation>
    </message>
    <message>
        <source>less</source>
        <translation>weniger</translation>
    </message>
    <message>
        <source>Position %1</source>
        <translation>Position %1</translation>
    </message>
    <message>
        <source> The model here is that of stand %1 alone, which is not put together with the object yet.</source>
        <translation> Das Modell hier ist das von Aufstellung %1 allein, die noch nicht mit dem Objekt zusammengefügt ist.</translation>
    </message>
</context>
<context>
    <name>Wording</name>
    <message>
        <source>The acquisition is not ended yet.</source>
        <translation>Die Aufnahme ist noch nicht beendet.</translation>
    </message>
    <message>
        <source>Ended: no position would show more than is worth a scan.</source>
        <translation>Beendet: Keine Position würde mehr zeigen, als einen Scan wert ist.</translation>
    </message>
    <message>
        <source>Ended: what is left overlaps the model too little from every position.</source>
        <translation>Beendet: Was übrig ist, überlappt von jeder Position aus zu wenig mit dem Modell.</translation>
    </message>
    <message>
        <source>Ended: the greatest number of views was taken.</source>
        <translation>Beendet: Die Höchstzahl an Ansichten ist aufgenommen.</translation>
    </message>
    <message>
        <source>Ended: scans could not be registered.</source>
        <translation>Beendet: Scans konnten nicht registriert werden.</translation>
    </message>
    <message>
        <source>The run was stopped.</source>
        <translation>Der Lauf wurde angehalten.</translation>
    </message>
    <message>
        <source>Ended by you.</source>
        <translation>Von Ihnen beendet.</translation>
    </message>
    <message>
        <source>Recorded scans, put together. No view was planned, so nothing is known of what is left.</source>
        <translation>Aufgezeichnete Scans, zusammengefügt. Es wurde keine Ansicht geplant, daher ist nichts über den Rest bekannt.</translation>
    </message>
    <message>
        <source>No ray reaches it</source>
        <translation>Kein Strahl erreicht es</translation>
    </message>
    <message>
        <source>Too steep from everywhere</source>
        <translation>Von überall zu steil</translation>
    </message>
    <message>
        <source>Light always blocked</source>
        <translation>Licht immer verdeckt</translation>
    </message>
    <message>
        <source>Receiver always blocked</source>
        <translation>Empfänger immer verdeckt</translation>
    </message>
    <message>
        <source>Not scanned yet</source>
        <translation>Noch nicht gescannt</translation>
    </message>
    <message>
        <source>Too little to be worth it</source>
        <translation>Zu wenig, um es wert zu sein</translation>
    </message>
    <message>
        <source>Looked at, no surface</source>
        <translation>Angesehen, keine Oberfläche</translation>
    </message>
    <message>
        <source>edge against the background</source>
        <translation>Rand vor dem Hintergrund</translation>
    </message>
    <message>
        <source>hidden behind the object</source>
        <translation>verdeckt durch das Objekt</translation>
    </message>
    <message>
        <source>light or camera blocked</source>
        <translation>Licht oder Kamera verdeckt</translation>
    </message>
    <message>
        <source>open border</source>
        <translation>offener Rand</translation>
    </message>
    <message>
        <source>rim of the scan</source>
        <translation>Rand des Scans</translation>
    </message>
    <message>
        <source>Erased by you</source>
        <translation>Von Ihnen gelöscht</translation>
    </message>
</context>
<context>
    <name>vantage::AcquirePage</name>
    <message>
        <source>Tr&amp;y again</source>
        <translation>&amp;Noch einmal versuchen</translation>
    </message>
    <message>
        <source>Scan from the same position once more.</source>
        <translation>Noch einmal von derselben Position scannen.</translation>
    </message>
    <message>
        <source>Turn it &amp;myself</source>
        <translation>Se&amp;lbst drehen</translation>
    </message>
    <message>
        <source>Go on without the table: you turn the object as the dial says.</source>
        <translation>Ohne den Drehtisch fortfahren: Sie drehen das Objekt, wie die Skala zeigt.</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>S&amp;tarten</translation>
    </message>
    <message>
        <source>Scan until nothing is left to see.</source>
        <translation>Scannen, bis nichts mehr zu sehen bleibt.</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Pause</translation>
    </message>
    <message>
        <source>Stop after the scan that is under way.</source>
        <translation>Nach dem laufenden Scan anhalten.</translation>
    </message>
    <message>
        <source>&amp;One scan</source>
        <translation>&amp;Ein Scan</translation>
    </message>
    <message>
        <source>Take the next scan and stop.</source>
        <translation>Den nächsten Scan aufnehmen und anhalten.</translation>
    </message>
    <message>
        <source>S&amp;top</source>
        <translation>St&amp;opp</translation>
    </message>
    <message>
        <source>Stop at once; the scan that is under way leaves no trace.</source>
        <translation>Sofort anhalten; der laufende Scan hinterlässt keine Spur.</translation>
    </message>
    <message>
        <source>The table &amp;is turned: scan</source>
        <translation>Der Tisch ist &amp;gedreht: scannen</translation>
    </message>
    <message>
        <source>Scan from the position shown.</source>
        <translation>Von der gezeigten Position scannen.</translation>
    </message>
    <message>
        <source>Allow %1 &amp;further views</source>
        <translation>Noch %1 Ansichten e&amp;rlauben</translation>
    </message>
    <message>
        <source>Raise the greatest number of views, so that you can go on.</source>
        <translation>Die Höchstzahl an Ansichten erhöhen, damit Sie fortfahren können.</translation>
    </message>
    <message>
        <source>En&amp;d here</source>
        <translation>H&amp;ier beenden</translation>
    </message>
    <message>
        <source>End the acquisition with what has been scanned.</source>
        <translation>Die Aufnahme mit dem beenden, was gescannt wurde.</translation>
    </message>
    <message>
        <source>T&amp;urn over…</source>
        <translation>Wen&amp;den…</translation>
    </message>
    <message>
        <source>Put the object on another side, to scan what this stand hides.</source>
        <translation>Das Objekt auf eine andere Seite legen, um zu scannen, was diese Aufstellung verdeckt.</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Assisted</source>
        <translation>Begleitet</translation>
    </message>
    <message>
        <source>Who turns the table</source>
        <translation>Wer den Tisch dreht</translation>
    </message>
    <message>
        <source>So far</source>
        <translation>Bisher</translation>
    </message>
    <message>
        <source>Scanning, registering, merging and planning; the bar below shows the step.</source>
        <translation>Scannen, Registrieren, Zusammenführen und Planen; die Leiste unten zeigt den Schritt.</translation>
    </message>
    <message>
        <source>Now: %1.</source>
        <translation>Jetzt: %1.</translation>
    </message>
    <message>
        <source>Stops after this scan.</source>
        <translation>Hält nach diesem Scan an.</translation>
    </message>
    <message>
        <source>Stopping.</source>
        <translation>Wird angehalten.</translation>
    </message>
    <message>
        <source>Reading scanner and object.</source>
        <translation>Scanner und Objekt werden gelesen.</translation>
    </message>
    <message>
        <source>Nothing has been scanned yet.</source>
        <translation>Es wurde noch nichts gescannt.</translation>
    </message>
    <message>
        <source>Stopped. The next view is ready.</source>
        <translation>Angehalten. Die nächste Ansicht ist bereit.</translation>
    </message>
    <message>
        <source>While this stand is scanned it is found out how the object was turned over; then both are one model.</source>
        <translation>Während diese Aufstellung gescannt wird, wird ermittelt, wie das Objekt gewendet wurde; dann sind beide ein Modell.</translation>
    </message>
    <message>
        <source>After this scan the next position is shown.</source>
        <translation>Nach diesem Scan wird die nächste Position gezeigt.</translation>
    </message>
    <message>
        <source>When nothing is left to see, the review opens by itself.</source>
        <translation>Wenn nichts mehr zu sehen bleibt, öffnet sich die Durchsicht von selbst.</translation>
    </message>
    <message>
        <source>You turn the table as the dial says; after each scan the best next view is shown.</source>
        <translation>Sie drehen den Tisch, wie die Skala zeigt; nach jedem Scan wird die nächste beste Ansicht gezeigt.</translation>
    </message>
    <message>
        <source>Run scans from one position after the other, each chosen by what is still unseen.</source>
        <translation>„Starten“ scannt von einer Position nach der anderen, jede gewählt nach dem, was noch ungesehen ist.</translation>
    </message>
    <message>
        <source>Go on scanning, or look at what there is so far.</source>
        <translation>Scannen Sie weiter, oder sehen Sie sich an, was es bisher gibt.</translation>
    </message>
    <message>
        <source>The review shows what is covered and what is left.</source>
        <translation>Die Durchsicht zeigt, was erfasst ist und was fehlt.</translation>
    </message>
    <message>
        <source>No scan is lost.</source>
        <translation>Kein Scan geht verloren.</translation>
    </message>
    <message>
        <source>Take scans as they &amp;come</source>
        <translation>Scans nehmen, wie sie &amp;kommen</translation>
    </message>
    <message>
        <source>&amp;Go on</source>
        <translation>&amp;Fortfahren</translation>
    </message>
    <message>
        <source>Turn the table as the dial says and scan with the scanner&apos;s own program: whatever it writes is taken, and the next position is shown.</source>
        <translation>Drehen Sie den Tisch, wie die Skala zeigt, und scannen Sie mit dem eigenen Programm des Scanners: Was es schreibt, wird genommen, und die nächste Position wird gezeigt.</translation>
    </message>
    <message>
        <source>Nothing runs that could pause.</source>
        <translation>Es läuft nichts, das pausieren könnte.</translation>
    </message>
    <message>
        <source>Nothing runs that could be stopped.</source>
        <translation>Es läuft nichts, das angehalten werden könnte.</translation>
    </message>
    <message>
        <source>Views in the model</source>
        <translation>Ansichten im Modell</translation>
    </message>
    <message>
        <source>Views in this stand</source>
        <translation>Ansichten in dieser Aufstellung</translation>
    </message>
    <message>
        <source>Scans that did not fit</source>
        <translation>Scans, die nicht passten</translation>
    </message>
    <message>
        <source>kept, but not part of the model</source>
        <translation>erhalten, aber nicht Teil des Modells</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>%1 new by the last scan</source>
        <translation>%1 neu durch den letzten Scan</translation>
    </message>
    <message>
        <source>Unseen edges</source>
        <translation>Ungesehene Ränder</translation>
    </message>
    <message>
        <source>%1 still attract views</source>
        <translation>%1 ziehen noch Ansichten an</translation>
    </message>
    <message>
        <source>Acquire</source>
        <translation>Aufnehmen</translation>
    </message>
    <message>
        <source>&amp;Next: review</source>
        <translation>&amp;Weiter: Durchsicht</translation>
    </message>
</context>
<context>
    <name>vantage::CalibratePage</name>
    <message>
        <source>&amp;Calibrate</source>
        <translation>&amp;Kalibrieren</translation>
    </message>
    <message>
        <source>Turn the table step by step, scan at every step, and find its axis from the scans.</source>
        <translation>Den Tisch schrittweise drehen, bei jedem Schritt scannen und seine Achse aus den Scans bestimmen.</translation>
    </message>
    <message>
        <source>S&amp;top</source>
        <translation>St&amp;opp</translation>
    </message>
    <message>
        <source>Stop at once; nothing is changed.</source>
        <translation>Sofort anhalten; nichts wird geändert.</translation>
    </message>
    <message>
        <source>&amp;Use this calibration</source>
        <translation>&amp;Diese Kalibrierung verwenden</translation>
    </message>
    <message>
        <source>Write it to a file in the folder of the session, and scan with it.</source>
        <translation>In eine Datei im Ordner der Sitzung schreiben und damit scannen.</translation>
    </message>
    <message>
        <source>Put any object on the table that looks different from every side, not round, and well in sight of the scanner. The table is turned through 60 to 200 degrees.</source>
        <translation>Stellen Sie ein beliebiges Objekt auf den Tisch, das von jeder Seite anders aussieht, nicht rund ist und vom Scanner gut gesehen wird. Der Tisch wird um 60 bis 200 Grad gedreht.</translation>
    </message>
    <message>
        <source>Number of scans</source>
        <translation>Anzahl der Scans</translation>
    </message>
    <message>
        <source>More scans make the axis surer and take longer.</source>
        <translation>Mehr Scans machen die Achse sicherer und dauern länger.</translation>
    </message>
    <message>
        <source> scans</source>
        <translation> Scans</translation>
    </message>
    <message>
        <source>The acquisition page opens. Without a calibration the table is taken to stand and turn as the profile of the scanner says.</source>
        <translation>Die Aufnahmeseite öffnet sich. Ohne Kalibrierung wird angenommen, dass der Tisch so steht und dreht, wie das Profil des Scanners sagt.</translation>
    </message>
    <message>
        <source>In use: %1</source>
        <translation>In Verwendung: %1</translation>
    </message>
    <message>
        <source>In use: the calibration in the profile.</source>
        <translation>In Verwendung: die Kalibrierung im Profil.</translation>
    </message>
    <message>
        <source>The table is not calibrated.</source>
        <translation>Der Drehtisch ist nicht kalibriert.</translation>
    </message>
    <message>
        <source>Nothing runs that could be stopped.</source>
        <translation>Es läuft nichts, das angehalten werden könnte.</translation>
    </message>
    <message>
        <source>There is nothing that could be used.</source>
        <translation>Es gibt nichts, das verwendet werden könnte.</translation>
    </message>
    <message>
        <source>Axis, sure to</source>
        <translation>Achse, sicher auf</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>° in its direction</source>
        <translation>° in ihrer Richtung</translation>
    </message>
    <message>
        <source>Turns, as it counts upwards</source>
        <translation>Dreht beim Aufwärtszählen</translation>
    </message>
    <message>
        <source>counter-clockwise</source>
        <translation>gegen den Uhrzeigersinn</translation>
    </message>
    <message>
        <source>clockwise</source>
        <translation>im Uhrzeigersinn</translation>
    </message>
    <message>
        <source>seen from above</source>
        <translation>von oben gesehen</translation>
    </message>
    <message>
        <source>Turned for every degree counted</source>
        <translation>Gedreht je gezähltem Grad</translation>
    </message>
    <message>
        <source>Scan at %1°</source>
        <translation>Scan bei %1°</translation>
    </message>
    <message>
        <source>off by %1°</source>
        <translation>um %1° daneben</translation>
    </message>
    <message>
        <source>not used</source>
        <translation>nicht verwendet</translation>
    </message>
    <message>
        <source>fits to %1 mm</source>
        <translation>passt auf %1 mm</translation>
    </message>
    <message>
        <source>it shows too little that turns</source>
        <translation>er zeigt zu wenig, das sich dreht</translation>
    </message>
    <message>
        <source>Calibrate the table</source>
        <translation>Drehtisch kalibrieren</translation>
    </message>
    <message>
        <source>&amp;Next: acquire</source>
        <translation>&amp;Weiter: aufnehmen</translation>
    </message>
</context>
<context>
    <name>vantage::CheckPage</name>
    <message>
        <source>Scanner and object could not be read: %1.</source>
        <translation>Scanner und Objekt konnten nicht gelesen werden: %1.</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>Geräte</translation>
    </message>
    <message>
        <source>&amp;Fit the object into the volume</source>
        <translation>&amp;Objekt in das Volumen einpassen</translation>
    </message>
    <message>
        <source>Scale and centre the object so that it stands inside the viewing volume.</source>
        <translation>Das Objekt so skalieren und zentrieren, dass es im Messvolumen steht.</translation>
    </message>
    <message>
        <source>Make a &amp;test turn</source>
        <translation>&amp;Probedrehung</translation>
    </message>
    <message>
        <source>Scan twice, a few positions apart, and compare the turn with the profile. Neither scan is kept.</source>
        <translation>Zweimal scannen, einige Positionen auseinander, und die Drehung mit dem Profil vergleichen. Keiner der Scans wird behalten.</translation>
    </message>
    <message>
        <source>Viewing volume</source>
        <translation>Messvolumen</translation>
    </message>
    <message>
        <source>What a scan sees</source>
        <translation>Was ein Scan sieht</translation>
    </message>
    <message>
        <source>Test turn</source>
        <translation>Probedrehung</translation>
    </message>
    <message>
        <source>Go back and choose something else. Nothing has been scanned yet.</source>
        <translation>Gehen Sie zurück und wählen Sie etwas anderes. Es wurde noch nichts gescannt.</translation>
    </message>
    <message>
        <source>Scanner and object are being read.</source>
        <translation>Scanner und Objekt werden gelesen.</translation>
    </message>
    <message>
        <source>Where the table stands before the scanner can be measured, or is taken as it is known.</source>
        <translation>Wo der Tisch vor dem Scanner steht, kann gemessen werden, oder wird als bekannt angenommen.</translation>
    </message>
    <message>
        <source>The acquisition page opens. Scanning begins when you say so.</source>
        <translation>Die Aufnahmeseite öffnet sich. Das Scannen beginnt, wenn Sie es sagen.</translation>
    </message>
    <message>
        <source>&amp;Next: calibrate</source>
        <translation>&amp;Weiter: kalibrieren</translation>
    </message>
    <message>
        <source>&amp;Next: acquire</source>
        <translation>&amp;Weiter: aufnehmen</translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation>Wird gelesen…</translation>
    </message>
    <message>
        <source>Nothing is chosen yet.</source>
        <translation>Es ist noch nichts gewählt.</translation>
    </message>
    <message>
        <source>What stands before the scanner is seen by its first scan.</source>
        <translation>Was vor dem Scanner steht, zeigt sein erster Scan.</translation>
    </message>
    <message>
        <source>The object reaches out of the viewing volume: what is outside cannot be scanned.</source>
        <translation>Das Objekt ragt aus dem Messvolumen: Was außerhalb ist, kann nicht gescannt werden.</translation>
    </message>
    <message>
        <source>The object stands inside the viewing volume.</source>
        <translation>Das Objekt steht im Messvolumen.</translation>
    </message>
    <message>
        <source>Object, radius about the axis</source>
        <translation>Objekt, Radius um die Achse</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Object, height</source>
        <translation>Objekt, Höhe</translation>
    </message>
    <message>
        <source>Object, lowest point</source>
        <translation>Objekt, tiefster Punkt</translation>
    </message>
    <message>
        <source>0 is the table</source>
        <translation>0 ist der Tisch</translation>
    </message>
    <message>
        <source>Positions of the scanner</source>
        <translation>Positionen des Scanners</translation>
    </message>
    <message>
        <source>Ranging rays per scan</source>
        <translation>Messstrahlen je Scan</translation>
    </message>
    <message>
        <source>A test turn tells whether the table turns about its axis as the profile says.</source>
        <translation>Eine Probedrehung zeigt, ob sich der Tisch so um seine Achse dreht, wie das Profil sagt.</translation>
    </message>
    <message>
        <source>Turn by the profile</source>
        <translation>Drehung laut Profil</translation>
    </message>
    <message>
        <source>Turn measured</source>
        <translation>Gemessene Drehung</translation>
    </message>
    <message>
        <source>%1° off, up to %2° are as expected</source>
        <translation>%1° daneben, bis zu %2° sind zu erwarten</translation>
    </message>
    <message>
        <source>Axis moved by</source>
        <translation>Achse verschoben um</translation>
    </message>
    <message>
        <source>up to %1 mm are as expected</source>
        <translation>bis zu %1 mm sind zu erwarten</translation>
    </message>
    <message>
        <source>The scans do not fit: %1</source>
        <translation>Die Scans passen nicht zusammen: %1</translation>
    </message>
    <message>
        <source>The scans fit, but the table was turned farther off than is expected of a person: turn it once more.</source>
        <translation>Die Scans passen, aber der Tisch wurde weiter daneben gedreht, als von einer Person zu erwarten ist: Drehen Sie ihn noch einmal.</translation>
    </message>
    <message>
        <source>The scans fit, but not where the profile expects the table after its turn: compare the figures, and calibrate the table or mend its profile.</source>
        <translation>Die Scans passen, aber nicht dort, wo das Profil den Tisch nach der Drehung erwartet: Vergleichen Sie die Zahlen, und kalibrieren Sie den Tisch, oder berichtigen Sie sein Profil.</translation>
    </message>
    <message>
        <source>The scans fit, but hold on to each other too little to measure the turn: %1</source>
        <translation>Die Scans passen, halten aber zu wenig aneinander, um die Drehung zu messen: %1</translation>
    </message>
    <message>
        <source>The scans fit. The person turned the table by %1° where %2° were asked for, as the scans tell to about %3° and %4 mm. How well the table itself turns, a turn by hand does not tell.</source>
        <translation>Die Scans passen. Der Tisch wurde von Hand um %1° gedreht, %2° waren verlangt; die Scans sagen das auf etwa %3° und %4 mm genau. Wie gut der Tisch selbst dreht, sagt eine Drehung von Hand nicht.</translation>
    </message>
    <message>
        <source>The scans fit. The table turns as expected.</source>
        <translation>Die Scans passen. Der Tisch dreht sich wie erwartet.</translation>
    </message>
    <message>
        <source>Check the set-up</source>
        <translation>Aufbau prüfen</translation>
    </message>
</context>
<context>
    <name>vantage::ChoosePage</name>
    <message>
        <source>None: the scans were recorded elsewhere</source>
        <translation>Keiner: Die Scans wurden anderswo aufgezeichnet</translation>
    </message>
    <message>
        <source>Take another file</source>
        <translation>Eine andere Datei nehmen</translation>
    </message>
    <message>
        <source>Vantage scans an object from positions that it chooses itself, until nothing is left to see.</source>
        <translation>Vantage scannt ein Objekt von selbst gewählten Positionen, bis nichts mehr zu sehen bleibt.</translation>
    </message>
    <message>
        <source>Scanner profile</source>
        <translation>Scannerprofil</translation>
    </message>
    <message>
        <source>Profile of the scanner and its turntable.</source>
        <translation>Profil des Scanners und seines Drehtisches.</translation>
    </message>
    <message>
        <source>Scanner profiles (*.json)</source>
        <translation>Scannerprofile (*.json)</translation>
    </message>
    <message>
        <source>Object for the simulated scanner</source>
        <translation>Objekt für den simulierten Scanner</translation>
    </message>
    <message>
        <source>Mesh that the simulated scanner looks at.</source>
        <translation>Netz, das der simulierte Scanner betrachtet.</translation>
    </message>
    <message>
        <source>Meshes (%1);;All files (*)</source>
        <translation>Netze (%1);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Save everything in</source>
        <translation>Alles speichern in</translation>
    </message>
    <message>
        <source>Folder of the session</source>
        <translation>Ordner der Sitzung</translation>
    </message>
    <message>
        <source>Take another folder</source>
        <translation>Einen anderen Ordner nehmen</translation>
    </message>
    <message>
        <source>Options</source>
        <translation>Optionen</translation>
    </message>
    <message>
        <source>&amp;Open a session…</source>
        <translation>Sitzung ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>Go on with a session from a file.</source>
        <translation>Mit einer Sitzung aus einer Datei fortfahren.</translation>
    </message>
    <message>
        <source>&amp;Import recorded scans…</source>
        <translation>Aufgezeichnete Scans &amp;importieren…</translation>
    </message>
    <message>
        <source>Make a session of range files that were recorded before; they can also be dropped on the window.</source>
        <translation>Eine Sitzung aus früher aufgezeichneten Tiefendateien machen; sie können auch auf das Fenster gezogen werden.</translation>
    </message>
    <message>
        <source>Choose the profile of the scanner first.</source>
        <translation>Wählen Sie zuerst das Profil des Scanners.</translation>
    </message>
    <message>
        <source>Choose an object first.</source>
        <translation>Wählen Sie zuerst ein Objekt.</translation>
    </message>
    <message>
        <source>Choose a folder first.</source>
        <translation>Wählen Sie zuerst einen Ordner.</translation>
    </message>
    <message>
        <source>Options contradict each other.</source>
        <translation>Optionen widersprechen sich.</translation>
    </message>
    <message>
        <source>The set-up of this session is shown. Its scanner and object stay as they are.</source>
        <translation>Der Aufbau dieser Sitzung wird gezeigt. Scanner und Objekt bleiben, wie sie sind.</translation>
    </message>
    <message>
        <source>Scanner and object are read and checked. Nothing is scanned yet.</source>
        <translation>Scanner und Objekt werden gelesen und geprüft. Es wird noch nichts gescannt.</translation>
    </message>
    <message>
        <source>The session that is open keeps what it was begun with.</source>
        <translation>Die geöffnete Sitzung behält, womit sie begonnen wurde.</translation>
    </message>
    <message>
        <source>Scanner and object</source>
        <translation>Scanner und Objekt</translation>
    </message>
    <message>
        <source>&amp;Next: check the set-up</source>
        <translation>&amp;Weiter: Aufbau prüfen</translation>
    </message>
    <message>
        <source>The session that is open keeps the object that it was begun with.</source>
        <translation>Die geöffnete Sitzung behält das Objekt, mit dem sie begonnen wurde.</translation>
    </message>
    <message>
        <source>Only the simulated scanner looks at a mesh, and another scanner is chosen.</source>
        <translation>Nur der simulierte Scanner betrachtet ein Netz, und es ist ein anderer Scanner gewählt.</translation>
    </message>
</context>
<context>
    <name>vantage::CompletenessBox</name>
    <message>
        <source>How complete the model is</source>
        <translation>Wie vollständig das Modell ist</translation>
    </message>
    <message>
        <source>Covered of what the scanner reaches</source>
        <translation>Erfasst von dem, was der Scanner erreicht</translation>
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
        <translation>Vantage ist bei der letzten Verwendung abgestürzt.</translation>
    </message>
    <message>
        <source>What it was doing is in %1 in the folder %2. It stays there, and was sent to nobody.</source>
        <translation>Was gerade geschah, steht in %1 im Ordner %2. Es bleibt dort und wurde niemandem geschickt.</translation>
    </message>
    <message>
        <source>The session %1 was open. Every scan was written before anything was made of it.</source>
        <translation>Die Sitzung %1 war geöffnet. Jeder Scan wurde geschrieben, bevor etwas daraus gemacht wurde.</translation>
    </message>
    <message>
        <source>&amp;Copy the trace</source>
        <translation>Protokoll des Absturzes &amp;kopieren</translation>
    </message>
    <message>
        <source>&amp;Open the session</source>
        <translation>Sitzung ö&amp;ffnen</translation>
    </message>
</context>
<context>
    <name>vantage::CutPictureView</name>
    <message>
        <source>The test scan, with what is cut of it in colours</source>
        <translation>Der Probescan, mit dem farbig Ausgeschnittenen</translation>
    </message>
</context>
<context>
    <name>vantage::DeviceBench</name>
    <message>
        <source>Connecting the devices</source>
        <translation>Geräte werden verbunden</translation>
    </message>
    <message>
        <source>Turning the table</source>
        <translation>Der Tisch wird gedreht</translation>
    </message>
    <message>
        <source>Setting the reference of the table</source>
        <translation>Der Nullpunkt des Tisches wird gesetzt</translation>
    </message>
    <message>
        <source>The devices were given up after a failure. Connect them again.</source>
        <translation>Die Geräte wurden nach einem Fehler aufgegeben. Verbinden Sie sie erneut.</translation>
    </message>
</context>
<context>
    <name>vantage::DeviceBox</name>
    <message>
        <source>&amp;Connect again</source>
        <translation>&amp;Erneut verbinden</translation>
    </message>
    <message>
        <source>Open the devices anew. A turntable then counts from where it stands.</source>
        <translation>Die Geräte neu öffnen. Ein Drehtisch zählt dann von dort, wo er steht.</translation>
    </message>
    <message>
        <source>Ho&amp;me</source>
        <translation>&amp;Nullpunkt</translation>
    </message>
    <message>
        <source>Let the table find its index, where it has one, and count from there.</source>
        <translation>Den Tisch seinen Index finden lassen, wo er einen hat, und von dort zählen.</translation>
    </message>
    <message>
        <source>St&amp;op</source>
        <translation>S&amp;topp</translation>
    </message>
    <message>
        <source>Stop the table, and whatever else goes on.</source>
        <translation>Den Tisch anhalten, und was sonst noch läuft.</translation>
    </message>
    <message>
        <source>Turn the table by %1 as it counts.</source>
        <translation>Den Tisch um %1 drehen, wie er zählt.</translation>
    </message>
    <message>
        <source>Something else is under way.</source>
        <translation>Etwas anderes läuft gerade.</translation>
    </message>
    <message>
        <source>The devices are not connected.</source>
        <translation>Die Geräte sind nicht verbunden.</translation>
    </message>
    <message>
        <source>ready</source>
        <translation>bereit</translation>
    </message>
    <message>
        <source>not ready</source>
        <translation>nicht bereit</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>Geräte</translation>
    </message>
    <message>
        <source>not connected</source>
        <translation>nicht verbunden</translation>
    </message>
    <message>
        <source>being connected…</source>
        <translation>wird verbunden…</translation>
    </message>
    <message>
        <source>&amp;Connect</source>
        <translation>&amp;Verbinden</translation>
    </message>
    <message>
        <source>Nothing runs that could be stopped.</source>
        <translation>Es läuft nichts, das angehalten werden könnte.</translation>
    </message>
</context>
<context>
    <name>vantage::DeviceEditor</name>
    <message>
        <source>What scans</source>
        <translation>Was scannt</translation>
    </message>
    <message>
        <source>The range scanner that takes the scans.</source>
        <translation>Der Tiefenscanner, der die Scans aufnimmt.</translation>
    </message>
    <message>
        <source>What turns</source>
        <translation>Was dreht</translation>
    </message>
    <message>
        <source>What brings the object from one position to the next.</source>
        <translation>Was das Objekt von einer Position zur nächsten bringt.</translation>
    </message>
    <message>
        <source>Port of the turntable</source>
        <translation>Anschluss des Drehtisches</translation>
    </message>
    <message>
        <source>The serial port that the turntable is connected to; any path can be typed.</source>
        <translation>Die serielle Schnittstelle, an der der Drehtisch angeschlossen ist; jeder Pfad kann eingegeben werden.</translation>
    </message>
    <message>
        <source>Language of the turntable</source>
        <translation>Sprache des Drehtisches</translation>
    </message>
    <message>
        <source>What the controller of the turntable speaks; it is asked when none is chosen.</source>
        <translation>Was die Steuerung des Drehtisches spricht; sie wird gefragt, wenn nichts gewählt ist.</translation>
    </message>
    <message>
        <source>Address of the camera</source>
        <translation>Adresse der Kamera</translation>
    </message>
    <message>
        <source>The first camera that answers</source>
        <translation>Die erste Kamera, die antwortet</translation>
    </message>
    <message>
        <source>No calibration: the table is where the profile says</source>
        <translation>Keine Kalibrierung: Der Tisch ist, wo das Profil sagt</translation>
    </message>
    <message>
        <source>Where the table&apos;s axis is, which way and how far it turns, as measured.</source>
        <translation>Wo die Achse des Tisches ist, in welche Richtung und wie weit er dreht, wie gemessen.</translation>
    </message>
    <message>
        <source>&amp;Load a rig…</source>
        <translation>Messaufbau &amp;laden…</translation>
    </message>
    <message>
        <source>Take scanner, turntable, profile and calibration from a file. Programs as devices are described that way.</source>
        <translation>Scanner, Drehtisch, Profil und Kalibrierung aus einer Datei nehmen. Programme als Geräte werden so beschrieben.</translation>
    </message>
    <message>
        <source>Load a rig</source>
        <translation>Messaufbau laden</translation>
    </message>
    <message>
        <source>Rigs (*.json)</source>
        <translation>Messaufbauten (*.json)</translation>
    </message>
    <message>
        <source>Simulated scanner</source>
        <translation>Simulierter Scanner</translation>
    </message>
    <message>
        <source>Files in a folder</source>
        <translation>Dateien in einem Ordner</translation>
    </message>
    <message>
        <source>Depth camera (OpenNI2)</source>
        <translation>Tiefenkamera (OpenNI2)</translation>
    </message>
    <message>
        <source>Scans of a session again</source>
        <translation>Scans einer Sitzung noch einmal</translation>
    </message>
    <message>
        <source>Simulated turntable</source>
        <translation>Simulierter Drehtisch</translation>
    </message>
    <message>
        <source>Turntable on a serial port</source>
        <translation>Drehtisch an serieller Schnittstelle</translation>
    </message>
    <message>
        <source>By hand</source>
        <translation>Von Hand</translation>
    </message>
    <message>
        <source>Nothing: a single scan</source>
        <translation>Nichts: ein einzelner Scan</translation>
    </message>
    <message>
        <source>Ask the turntable</source>
        <translation>Den Drehtisch fragen</translation>
    </message>
    <message>
        <source>Folder that range files are written to</source>
        <translation>Ordner, in den Tiefendateien geschrieben werden</translation>
    </message>
    <message>
        <source>Session</source>
        <translation>Sitzung</translation>
    </message>
    <message>
        <source>Sessions (*.vantage)</source>
        <translation>Sitzungen (*.vantage)</translation>
    </message>
    <message>
        <source>Calibration of the table</source>
        <translation>Kalibrierung des Drehtisches</translation>
    </message>
    <message>
        <source>Calibrations (*.json)</source>
        <translation>Kalibrierungen (*.json)</translation>
    </message>
    <message>
        <source>Take another file</source>
        <translation>Eine andere Datei nehmen</translation>
    </message>
    <message>
        <source>No port is there: connect the table, or type its path</source>
        <translation>Kein Anschluss vorhanden: Verbinden Sie den Tisch, oder geben Sie den Pfad ein</translation>
    </message>
    <message>
        <source>Choose the folder that the scanner&apos;s program writes to.</source>
        <translation>Wählen Sie den Ordner, in den das Programm des Scanners schreibt.</translation>
    </message>
    <message>
        <source>Choose the session whose scans are taken again.</source>
        <translation>Wählen Sie die Sitzung, deren Scans noch einmal genommen werden.</translation>
    </message>
    <message>
        <source>The simulated scanner sees the simulated table only.</source>
        <translation>Der simulierte Scanner sieht nur den simulierten Tisch.</translation>
    </message>
    <message>
        <source>A real scanner does not see the simulated table.</source>
        <translation>Ein echter Scanner sieht den simulierten Tisch nicht.</translation>
    </message>
    <message>
        <source>Choose the port of the turntable.</source>
        <translation>Wählen Sie den Anschluss des Drehtisches.</translation>
    </message>
    <message>
        <source>You turn the table as the dial says, about as far as asked: where it really came to stand is found from the scan.</source>
        <translation>Sie drehen den Tisch, wie die Skala zeigt, etwa so weit wie verlangt: Wo er wirklich zu stehen kam, wird aus dem Scan ermittelt.</translation>
    </message>
</context>
<context>
    <name>vantage::DiagnosticsDialog</name>
    <message>
        <source>With the names of &amp;files and folders</source>
        <translation>Mit den &amp;Namen von Dateien und Ordnern</translation>
    </message>
    <message>
        <source>Diagnostics</source>
        <translation>Diagnose</translation>
    </message>
    <message>
        <source>For somebody who is to help. It is sent to nobody: copy it to where it is wanted.</source>
        <translation>Für jemanden, der helfen soll. Es wird niemandem geschickt: Kopieren Sie es dorthin, wo es gebraucht wird.</translation>
    </message>
    <message>
        <source>Without them every name of a file is replaced by &lt;file&gt;.</source>
        <translation>Ohne sie wird jeder Dateiname durch &lt;file&gt; ersetzt.</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>Put the text into the clipboard.</source>
        <translation>Den Text in die Zwischenablage legen.</translation>
    </message>
</context>
<context>
    <name>vantage::EraseBar</name>
    <message>
        <source>How far above the table</source>
        <translation>Wie weit über dem Tisch</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>How large a piece may be</source>
        <translation>Wie groß ein Stück sein darf</translation>
    </message>
    <message>
        <source> mm²</source>
        <translation> mm²</translation>
    </message>
    <message>
        <source>Only the near side</source>
        <translation>Nur die vordere Seite</translation>
    </message>
    <message>
        <source>Lasso</source>
        <translation>Lasso</translation>
    </message>
    <message>
        <source>Draw around it, in any shape</source>
        <translation>In beliebiger Form umfahren</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Rechteck</translation>
    </message>
    <message>
        <source>Draw a rectangle around it</source>
        <translation>Ein Rechteck darum ziehen</translation>
    </message>
    <message>
        <source>Below a plane</source>
        <translation>Unter einer Ebene</translation>
    </message>
    <message>
        <source>All that lies lower than a height above the table</source>
        <translation>Alles, was tiefer liegt als eine Höhe über dem Tisch</translation>
    </message>
    <message>
        <source>Loose pieces</source>
        <translation>Lose Stücke</translation>
    </message>
    <message>
        <source>Pieces that hang together with nothing else; the largest one stays</source>
        <translation>Stücke, die mit nichts anderem zusammenhängen; das größte bleibt</translation>
    </message>
    <message>
        <source>What lies behind it, after a gap, stays</source>
        <translation>Was mit Abstand dahinter liegt, bleibt</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Erase what is marked; Undo takes it back</source>
        <translation>Das Markierte löschen; „Rückgängig“ nimmt es zurück</translation>
    </message>
    <message>
        <source>Done (Esc)</source>
        <translation>Fertig (Esc)</translation>
    </message>
    <message>
        <source>Erase nothing more</source>
        <translation>Nichts weiter löschen</translation>
    </message>
    <message>
        <source>Draw around what is not the object with the left button held. By keys: arrows, space for a corner, Enter.</source>
        <translation>Umfahren Sie mit gedrückter linker Maustaste, was nicht zum Objekt gehört. Mit Tasten: Pfeile, Leertaste für eine Ecke, Eingabetaste.</translation>
    </message>
    <message>
        <source>Draw a rectangle around what is not the object with the left button held. By keys: arrows, space, arrows, Enter.</source>
        <translation>Ziehen Sie mit gedrückter linker Maustaste ein Rechteck um das, was nicht zum Objekt gehört. Mit Tasten: Pfeile, Leertaste, Pfeile, Eingabetaste.</translation>
    </message>
    <message>
        <source>Looking for it…</source>
        <translation>Wird gesucht…</translation>
    </message>
    <message>
        <source>The model has no loose piece of that size.</source>
        <translation>Das Modell hat kein loses Stück dieser Größe.</translation>
    </message>
    <message>
        <source>Nothing of the model lies there.</source>
        <translation>Dort liegt nichts vom Modell.</translation>
    </message>
    <message>
        <source>The marked piece would go, %1.</source>
        <translation>Das markierte Stück würde gelöscht, %1.</translation>
    </message>
    <message>
        <source>The %1 marked pieces would go, %2 together.</source>
        <translation>Die %1 markierten Stücke würden gelöscht, zusammen %2.</translation>
    </message>
    <message>
        <source>Nothing is marked that could be erased.</source>
        <translation>Es ist nichts markiert, das gelöscht werden könnte.</translation>
    </message>
</context>
<context>
    <name>vantage::EraseDesk</name>
    <message>
        <source>An earlier moment is shown: go back to now first.</source>
        <translation>Gezeigt wird ein früherer Zeitpunkt: Gehen Sie zuerst zurück zu jetzt.</translation>
    </message>
</context>
<context>
    <name>vantage::FinishPage</name>
    <message>
        <source>Export the model</source>
        <translation>Modell exportieren</translation>
    </message>
    <message>
        <source>Export ST&amp;L</source>
        <translation>S&amp;TL exportieren</translation>
    </message>
    <message>
        <source>Triangles only, for printing and CAD.</source>
        <translation>Nur Dreiecke, für Druck und CAD.</translation>
    </message>
    <message>
        <source>Export &amp;PLY</source>
        <translation>&amp;PLY exportieren</translation>
    </message>
    <message>
        <source>With a confidence per vertex and a view per face.</source>
        <translation>Mit einer Konfidenz je Eckpunkt und einer Ansicht je Fläche.</translation>
    </message>
    <message>
        <source>Export &amp;OBJ</source>
        <translation>&amp;OBJ exportieren</translation>
    </message>
    <message>
        <source>Text that nearly every program reads.</source>
        <translation>Text, den fast jedes Programm liest.</translation>
    </message>
    <message>
        <source>Export &amp;as…</source>
        <translation>&amp;Exportieren als…</translation>
    </message>
    <message>
        <source>To a file of your choice.</source>
        <translation>In eine Datei Ihrer Wahl.</translation>
    </message>
    <message>
        <source>STL (*.stl);;PLY (*.ply);;OBJ (*.obj);;3MF (*.3mf)</source>
        <translation>STL (*.stl);;PLY (*.ply);;OBJ (*.obj);;3MF (*.3mf)</translation>
    </message>
    <message>
        <source>Rea&amp;dy to print…</source>
        <translation>&amp;Druckfertig…</translation>
    </message>
    <message>
        <source>Closed, in one piece, or you learn why not; also fewer triangles, inches, 3MF.</source>
        <translation>Geschlossen, in einem Stück, oder Sie erfahren, warum nicht; auch weniger Dreiecke, Zoll, 3MF.</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Bericht</translation>
    </message>
    <message>
        <source>&amp;Write the report</source>
        <translation>Beri&amp;cht schreiben</translation>
    </message>
    <message>
        <source>One HTML page with pictures, figures, times and what is left.</source>
        <translation>Eine HTML-Seite mit Bildern, Zahlen, Zeiten und dem, was fehlt.</translation>
    </message>
    <message>
        <source>Written: %1 (&lt;a href=&quot;%2&quot;&gt;open&lt;/a&gt;, &lt;a href=&quot;%3&quot;&gt;show the folder&lt;/a&gt;)</source>
        <translation>Geschrieben: %1 (&lt;a href=&quot;%2&quot;&gt;öffnen&lt;/a&gt;, &lt;a href=&quot;%3&quot;&gt;Ordner zeigen&lt;/a&gt;)</translation>
    </message>
    <message>
        <source>Not written: the model cannot be printed as one piece.</source>
        <translation>Nicht geschrieben: Das Modell kann nicht als ein Stück gedruckt werden.</translation>
    </message>
    <message>
        <source>Vantage</source>
        <translation>Vantage</translation>
    </message>
    <message>
        <source>%1 is there already.</source>
        <translation>%1 gibt es schon.</translation>
    </message>
    <message>
        <source>In %1. If you replace it, what it holds now is gone.</source>
        <translation>In %1. Wenn Sie es ersetzen, ist sein jetziger Inhalt verloren.</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>&amp;Ersetzen</translation>
    </message>
    <message>
        <source>Export for printing</source>
        <translation>Zum Drucken exportieren</translation>
    </message>
    <message>
        <source>3MF (*.3mf);;STL (*.stl);;PLY (*.ply);;OBJ (*.obj)</source>
        <translation>3MF (*.3mf);;STL (*.stl);;PLY (*.ply);;OBJ (*.obj)</translation>
    </message>
    <message>
        <source>This session stays on the disk as it is. A new one begins with scanner and object.</source>
        <translation>Diese Sitzung bleibt auf dem Datenträger, wie sie ist. Eine neue beginnt mit Scanner und Objekt.</translation>
    </message>
    <message>
        <source>Into %1</source>
        <translation>Nach %1</translation>
    </message>
    <message>
        <source>An earlier moment is shown; written is the session as it is now.</source>
        <translation>Gezeigt wird ein früherer Zeitpunkt; geschrieben wird die Sitzung, wie sie jetzt ist.</translation>
    </message>
    <message>
        <source>The scans have colours: PLY and OBJ keep them, STL and 3MF do not.</source>
        <translation>Die Scans haben Farben: PLY und OBJ behalten sie, STL und 3MF nicht.</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>Abschließen</translation>
    </message>
    <message>
        <source>&amp;New session</source>
        <translation>&amp;Neue Sitzung</translation>
    </message>
</context>
<context>
    <name>vantage::HelpDesk</name>
    <message>
        <source>&amp;Manual</source>
        <translation>&amp;Handbuch</translation>
    </message>
    <message>
        <source>M&amp;essages and what to do</source>
        <translation>&amp;Meldungen und was zu tun ist</translation>
    </message>
    <message>
        <source>&amp;Keyboard</source>
        <translation>&amp;Tastatur</translation>
    </message>
    <message>
        <source>&amp;Words</source>
        <translation>Be&amp;griffe</translation>
    </message>
</context>
<context>
    <name>vantage::HelpWindow</name>
    <message>
        <source>Manual – Vantage</source>
        <translation>Handbuch – Vantage</translation>
    </message>
    <message>
        <source>The manual is not there: %1 cannot be read. On Debian it comes with the package vantage-data.</source>
        <translation>Das Handbuch fehlt: %1 kann nicht gelesen werden. Unter Debian kommt es mit dem Paket vantage-data.</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Zurück</translation>
    </message>
    <message>
        <source>The page before (Alt+Left).</source>
        <translation>Die Seite davor (Alt+Links).</translation>
    </message>
    <message>
        <source>&amp;Forward</source>
        <translation>&amp;Vorwärts</translation>
    </message>
    <message>
        <source>The page after (Alt+Right).</source>
        <translation>Die Seite danach (Alt+Rechts).</translation>
    </message>
    <message>
        <source>&amp;Contents</source>
        <translation>&amp;Inhalt</translation>
    </message>
    <message>
        <source>All chapters (Alt+Home).</source>
        <translation>Alle Kapitel (Alt+Pos1).</translation>
    </message>
    <message>
        <source>No page was shown before.</source>
        <translation>Davor wurde keine Seite gezeigt.</translation>
    </message>
    <message>
        <source>No page comes after.</source>
        <translation>Danach kommt keine Seite.</translation>
    </message>
    <message>
        <source>Search all pages (Ctrl+F)</source>
        <translation>Alle Seiten durchsuchen (Strg+F)</translation>
    </message>
    <message>
        <source>Words to search for in all pages</source>
        <translation>Wörter, die auf allen Seiten gesucht werden</translation>
    </message>
    <message>
        <source>Chapters, or what was found</source>
        <translation>Kapitel, oder was gefunden wurde</translation>
    </message>
    <message>
        <source>No section of the manual has these words.</source>
        <translation>Kein Abschnitt des Handbuchs hat diese Wörter.</translation>
    </message>
</context>
<context>
    <name>vantage::ImportDialog</name>
    <message>
        <source>Scanner</source>
        <translation>Scanner</translation>
    </message>
    <message>
        <source>Scans of a known scanner lie on its rays; of others the rays are found from the files.</source>
        <translation>Scans eines bekannten Scanners liegen auf seinen Strahlen; bei anderen werden die Strahlen aus den Dateien ermittelt.</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>What the command line calls --unit.</source>
        <translation>Auf der Kommandozeile: --unit.</translation>
    </message>
    <message>
        <source>Where the scanner looks</source>
        <translation>Wohin der Scanner schaut</translation>
    </message>
    <message>
        <source>In the coordinates of the files; what the command line calls --frame.</source>
        <translation>In den Koordinaten der Dateien; auf der Kommandozeile: --frame.</translation>
    </message>
    <message>
        <source>Rows and columns</source>
        <translation>Zeilen und Spalten</translation>
    </message>
    <message>
        <source>Of points as text, one line for every cell; what the command line calls --grid.</source>
        <translation>Von Punkten als Text, eine Zeile je Zelle; auf der Kommandozeile: --grid.</translation>
    </message>
    <message>
        <source>As the files say, for instance 480x640</source>
        <translation>Wie in den Dateien, zum Beispiel 480x640</translation>
    </message>
    <message>
        <source>Where nothing was measured</source>
        <translation>Wo nichts gemessen wurde</translation>
    </message>
    <message>
        <source>The value that stands where nothing was measured; what the command line calls --no-sample.</source>
        <translation>Der Wert dort, wo nichts gemessen wurde; auf der Kommandozeile: --no-sample.</translation>
    </message>
    <message>
        <source>As it is found, for instance 0 or -9999</source>
        <translation>Wie gefunden, zum Beispiel 0 oder -9999</translation>
    </message>
    <message>
        <source>Import recorded scans</source>
        <translation>Aufgezeichnete Scans importieren</translation>
    </message>
    <message>
        <source>Add scans to the session</source>
        <translation>Scans zur Sitzung hinzufügen</translation>
    </message>
    <message>
        <source>Scans of one scanner, of one object. They are registered and merged; where they were taken from is found, or said here.</source>
        <translation>Scans eines Scanners, von einem Objekt. Sie werden registriert und zusammengeführt; von wo sie aufgenommen wurden, wird ermittelt oder hier angegeben.</translation>
    </message>
    <message>
        <source>Each scan is registered at the position that it was taken from, one after the other.</source>
        <translation>Jeder Scan wird an der Position registriert, von der er aufgenommen wurde, einer nach dem anderen.</translation>
    </message>
    <message>
        <source>Taken with</source>
        <translation>Aufgenommen mit</translation>
    </message>
    <message>
        <source>List of poses</source>
        <translation>Liste der Posen</translation>
    </message>
    <message>
        <source>None: as the files say, or found</source>
        <translation>Keine: wie in den Dateien, oder ermittelt</translation>
    </message>
    <message>
        <source>Take a file</source>
        <translation>Eine Datei nehmen</translation>
    </message>
    <message>
        <source>List of poses (.conf)</source>
        <translation>Liste der Posen (.conf)</translation>
    </message>
    <message>
        <source>as it is found</source>
        <translation>wie gefunden</translation>
    </message>
    <message>
        <source>Unit (--unit)</source>
        <translation>Einheit (--unit)</translation>
    </message>
    <message>
        <source>The scanner looks (--frame)</source>
        <translation>Der Scanner schaut (--frame)</translation>
    </message>
    <message>
        <source>Rows × columns (--grid)</source>
        <translation>Zeilen × Spalten (--grid)</translation>
    </message>
    <message>
        <source>No sample is (--no-sample)</source>
        <translation>Keine Messung ist (--no-sample)</translation>
    </message>
    <message>
        <source>Folder of the session</source>
        <translation>Ordner der Sitzung</translation>
    </message>
    <message>
        <source>Save everything in</source>
        <translation>Alles speichern in</translation>
    </message>
    <message>
        <source>&amp;Import</source>
        <translation>&amp;Importieren</translation>
    </message>
    <message>
        <source>&amp;Add</source>
        <translation>&amp;Hinzufügen</translation>
    </message>
    <message>
        <source>a scanner without a profile: its rays are found from the files</source>
        <translation>ein Scanner ohne Profil: Seine Strahlen werden aus den Dateien ermittelt</translation>
    </message>
    <message>
        <source>the scanner of %1</source>
        <translation>der Scanner von %1</translation>
    </message>
    <message>
        <source>Poses (*.conf)</source>
        <translation>Posen (*.conf)</translation>
    </message>
    <message>
        <source>Something else is under way.</source>
        <translation>Etwas anderes läuft gerade.</translation>
    </message>
    <message>
        <source>Add the range files first.</source>
        <translation>Fügen Sie zuerst die Tiefendateien hinzu.</translation>
    </message>
    <message>
        <source>Say of every file from which position it was taken.</source>
        <translation>Geben Sie für jede Datei an, von welcher Position sie aufgenommen wurde.</translation>
    </message>
    <message>
        <source>Positions and a list of poses both say where the scans were taken: give one.</source>
        <translation>Positionen und eine Liste der Posen sagen beide, wo die Scans aufgenommen wurden: Geben Sie nur eines an.</translation>
    </message>
    <message>
        <source>Rows and columns are two numbers from 2 on, for instance 480x640.</source>
        <translation>Zeilen und Spalten sind zwei Zahlen ab 2, zum Beispiel 480x640.</translation>
    </message>
    <message>
        <source>The value where nothing was measured is a number.</source>
        <translation>Der Wert, wo nichts gemessen wurde, ist eine Zahl.</translation>
    </message>
    <message>
        <source>Choose a folder first.</source>
        <translation>Wählen Sie zuerst einen Ordner.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
</context>
<context>
    <name>vantage::JobPanel</name>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Cancel what is being computed</source>
        <translation>Die laufende Berechnung abbrechen</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Bereit</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1; %2</translation>
    </message>
</context>
<context>
    <name>vantage::JobRunner</name>
    <message>
        <source>There is not enough memory for this.</source>
        <translation>Dafür reicht der Speicher nicht.</translation>
    </message>
</context>
<context>
    <name>vantage::LogPanel</name>
    <message>
        <source>Log</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>Nothing has happened yet.</source>
        <translation>Es ist noch nichts geschehen.</translation>
    </message>
    <message>
        <source>Problem: %1</source>
        <translation>Problem: %1</translation>
    </message>
</context>
<context>
    <name>vantage::MainWindow</name>
    <message>
        <source>Session</source>
        <translation>Sitzung</translation>
    </message>
    <message>
        <source>Objective</source>
        <translation>Zielfunktion</translation>
    </message>
    <message>
        <source>Ctrl+2</source>
        <translation>Ctrl+2</translation>
    </message>
    <message>
        <source>Positional space</source>
        <translation>Positionsraum</translation>
    </message>
    <message>
        <source>Ctrl+3</source>
        <translation>Ctrl+3</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Karte</translation>
    </message>
    <message>
        <source>Ctrl+4</source>
        <translation>Ctrl+4</translation>
    </message>
    <message>
        <source>Why this view</source>
        <translation>Warum diese Ansicht</translation>
    </message>
    <message>
        <source>Ctrl+5</source>
        <translation>Ctrl+5</translation>
    </message>
    <message>
        <source>Time line</source>
        <translation>Zeitleiste</translation>
    </message>
    <message>
        <source>Ctrl+6</source>
        <translation>Ctrl+6</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>Ctrl+7</source>
        <translation>Ctrl+7</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>&amp;Settings…</source>
        <translation>&amp;Einstellungen…</translation>
    </message>
    <message>
        <source>Ctrl+,</source>
        <translation>Ctrl+,</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>Copy &amp;diagnostics…</source>
        <translation>&amp;Diagnose kopieren…</translation>
    </message>
    <message>
        <source>&amp;About Vantage</source>
        <translation>Ü&amp;ber Vantage</translation>
    </message>
    <message>
        <source>&amp;Session</source>
        <translation>&amp;Sitzung</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>Ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>Open to &amp;look at…</source>
        <translation>Zum &amp;Ansehen öffnen…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+O</source>
        <translation>Ctrl+Shift+O</translation>
    </message>
    <message>
        <source>&amp;Import or add scans…</source>
        <translation>Scans &amp;importieren oder hinzufügen…</translation>
    </message>
    <message>
        <source>Ctrl+I</source>
        <translation>Ctrl+I</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>S&amp;chließen</translation>
    </message>
    <message>
        <source>&amp;Run or go on</source>
        <translation>&amp;Starten oder fortfahren</translation>
    </message>
    <message>
        <source>F5</source>
        <translation>F5</translation>
    </message>
    <message>
        <source>One &amp;scan</source>
        <translation>&amp;Ein Scan</translation>
    </message>
    <message>
        <source>F6</source>
        <translation>F6</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Pause</translation>
    </message>
    <message>
        <source>F7</source>
        <translation>F7</translation>
    </message>
    <message>
        <source>S&amp;top (also Esc)</source>
        <translation>S&amp;topp (auch Esc)</translation>
    </message>
    <message>
        <source>Shift+F5</source>
        <translation>Shift+F5</translation>
    </message>
    <message>
        <source>T&amp;urn the object over…</source>
        <translation>&amp;Objekt wenden…</translation>
    </message>
    <message>
        <source>Ctrl+T</source>
        <translation>Ctrl+T</translation>
    </message>
    <message>
        <source>How the stan&amp;ds lie in each other…</source>
        <translation>&amp;Lage der Aufstellungen zueinander…</translation>
    </message>
    <message>
        <source>Ctrl+D</source>
        <translation>Ctrl+D</translation>
    </message>
    <message>
        <source>Next pa&amp;ge</source>
        <translation>&amp;Nächste Seite</translation>
    </message>
    <message>
        <source>Alt+Right</source>
        <translation>Alt+Right</translation>
    </message>
    <message>
        <source>Page &amp;before</source>
        <translation>&amp;Vorherige Seite</translation>
    </message>
    <message>
        <source>Alt+Left</source>
        <translation>Alt+Left</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>&amp;Einpassen</translation>
    </message>
    <message>
        <source>Fr&amp;ont</source>
        <translation>&amp;Vorn</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>&amp;Oben</translation>
    </message>
    <message>
        <source>Scanner&apos;s &amp;eye</source>
        <translation>&amp;Blick des Scanners</translation>
    </message>
    <message>
        <source>Ob&amp;lique</source>
        <translation>&amp;Schräg</translation>
    </message>
    <message>
        <source>Fit with the ta&amp;ble</source>
        <translation>&amp;Mit dem Tisch einpassen</translation>
    </message>
    <message>
        <source>Objective as bars o&amp;r dial</source>
        <translation>Zielfunktion als Balken oder &amp;Ring</translation>
    </message>
    <message>
        <source>Ctrl+B</source>
        <translation>Ctrl+B</translation>
    </message>
    <message>
        <source>&amp;Now</source>
        <translation>&amp;Jetzt</translation>
    </message>
    <message>
        <source>Ctrl+End</source>
        <translation>Ctrl+End</translation>
    </message>
    <message>
        <source>To the &amp;page</source>
        <translation>&amp;Zur Seite</translation>
    </message>
    <message>
        <source>Ctrl+1</source>
        <translation>Ctrl+1</translation>
    </message>
    <message>
        <source>&amp;Usual layout</source>
        <translation>Übliche &amp;Anordnung</translation>
    </message>
    <message>
        <source>The session is damaged: %1 things in it could not be read. What is whole is shown.</source>
        <translation>Die Sitzung ist beschädigt: %1 Dinge darin konnten nicht gelesen werden. Gezeigt wird, was heil ist.</translation>
    </message>
    <message>
        <source>Nothing runs that could pause.</source>
        <translation>Es läuft nichts, das pausieren könnte.</translation>
    </message>
    <message>
        <source>Nothing runs that could be stopped.</source>
        <translation>Es läuft nichts, das angehalten werden könnte.</translation>
    </message>
    <message>
        <source>Vantage</source>
        <translation>Vantage</translation>
    </message>
    <message>
        <source>%1 (to be looked at only) – Vantage</source>
        <translation>%1 (nur zum Ansehen) – Vantage</translation>
    </message>
    <message>
        <source>%1 – Vantage</source>
        <translation>%1 – Vantage</translation>
    </message>
    <message>
        <source>The model</source>
        <translation>Das Modell</translation>
    </message>
    <message>
        <source>From the front</source>
        <translation>Von vorn</translation>
    </message>
    <message>
        <source>From above</source>
        <translation>Von oben</translation>
    </message>
    <message>
        <source>About Vantage</source>
        <translation>Über Vantage</translation>
    </message>
    <message>
        <source>Vantage %1

A scanning workstation that decides where to scan next, after R. Pito, &quot;A Solution to the Next Best View Problem for Automated Surface Acquisition&quot;, 1999.

Apache License 2.0. Made with Qt, VTK, Embree, Eigen, OpenMesh, assimp and SQLite.</source>
        <translation>Vantage %1

Eine Scan-Arbeitsstation, die entscheidet, von wo als Nächstes gescannt wird, nach R. Pito, „A Solution to the Next Best View Problem for Automated Surface Acquisition“, 1999.

Apache-Lizenz 2.0. Erstellt mit Qt, VTK, Embree, Eigen, OpenMesh, assimp und SQLite.</translation>
    </message>
    <message>
        <source>&amp;Erase from the model…</source>
        <translation>Aus dem Modell &amp;löschen…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+E</source>
        <translation>Ctrl+Shift+E</translation>
    </message>
    <message>
        <source>Ne&amp;w session</source>
        <translation>Ne&amp;ue Sitzung</translation>
    </message>
    <message>
        <source>Recentl&amp;y opened</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>E&amp;xport the model…</source>
        <translation>Modell e&amp;xportieren…</translation>
    </message>
    <message>
        <source>Ctrl+E</source>
        <translation>Ctrl+E</translation>
    </message>
    <message>
        <source>Write t&amp;he report</source>
        <translation>Be&amp;richt schreiben</translation>
    </message>
    <message>
        <source>Ctrl+R</source>
        <translation>Ctrl+R</translation>
    </message>
    <message>
        <source>How the model is &amp;drawn</source>
        <translation>&amp;Darstellung des Modells</translation>
    </message>
</context>
<context>
    <name>vantage::ManualBrowser</name>
    <message>
        <source>Page of the manual</source>
        <translation>Seite des Handbuchs</translation>
    </message>
</context>
<context>
    <name>vantage::ModelPane</name>
    <message>
        <source>Colour of the surface</source>
        <translation>Farbe der Oberfläche</translation>
    </message>
    <message>
        <source>Plain</source>
        <translation>Einfarbig</translation>
    </message>
    <message>
        <source>Confidence</source>
        <translation>Konfidenz</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Age</source>
        <translation>Alter</translation>
    </message>
    <message>
        <source>Colour of the unseen edges</source>
        <translation>Farbe der ungesehenen Ränder</translation>
    </message>
    <message>
        <source>Edges by kind</source>
        <translation>Ränder nach Art</translation>
    </message>
    <message>
        <source>Edges by state</source>
        <translation>Ränder nach Zustand</translation>
    </message>
    <message>
        <source>Unseen</source>
        <translation>Ungesehen</translation>
    </message>
    <message>
        <source>Unseen edges: where the model ends and the unseen begins (void patches)</source>
        <translation>Ungesehene Ränder: wo das Modell endet und das Ungesehene beginnt (Leerflächen)</translation>
    </message>
    <message>
        <source>Last rays</source>
        <translation>Letzte Strahlen</translation>
    </message>
    <message>
        <source>Rays of the last view</source>
        <translation>Strahlen der letzten Ansicht</translation>
    </message>
    <message>
        <source>Next rays</source>
        <translation>Nächste Strahlen</translation>
    </message>
    <message>
        <source>Rays of the proposed view, or of the position asked about</source>
        <translation>Strahlen der vorgeschlagenen Ansicht, oder der abgefragten Position</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tisch</translation>
    </message>
    <message>
        <source>Turntable with its scale</source>
        <translation>Drehtisch mit seiner Skala</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>Stand</source>
        <translation>Aufstellung</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Einpassen</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Vorn</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>Scanner&apos;s eye</source>
        <translation>Blick des Scanners</translation>
    </message>
    <message>
        <source>Oblique</source>
        <translation>Schräg</translation>
    </message>
    <message>
        <source>Erase…</source>
        <translation>Löschen…</translation>
    </message>
    <message>
        <source>Erase what is not the object: putty, a clamp, the table, loose pieces</source>
        <translation>Löschen, was nicht zum Objekt gehört: Knete, eine Klemme, der Tisch, lose Stücke</translation>
    </message>
</context>
<context>
    <name>vantage::ModelView</name>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>The model cannot be shown: %1</source>
        <translation>Das Modell kann nicht gezeigt werden: %1</translation>
    </message>
    <message>
        <source>The cut cannot be computed: %1</source>
        <translation>Der Schnitt kann nicht berechnet werden: %1</translation>
    </message>
</context>
<context>
    <name>vantage::NextViewBox</name>
    <message>
        <source>Next view</source>
        <translation>Nächste Ansicht</translation>
    </message>
    <message>
        <source>T&amp;ake it</source>
        <translation>Neh&amp;men</translation>
    </message>
    <message>
        <source>Scan from this position next.</source>
        <translation>Als Nächstes von dieser Position scannen.</translation>
    </message>
    <message>
        <source>Proposa&amp;l</source>
        <translation>&amp;Vorschlag</translation>
    </message>
    <message>
        <source>Go back to the proposed position.</source>
        <translation>Zurück zur vorgeschlagenen Position.</translation>
    </message>
    <message>
        <source>Another position</source>
        <translation>Eine andere Position</translation>
    </message>
    <message>
        <source>Other:</source>
        <translation>Andere:</translation>
    </message>
    <message>
        <source>Put the scanner at position %1.</source>
        <translation>Stellen Sie den Scanner auf Position %1.</translation>
    </message>
    <message>
        <source>Leave the table as it stands.</source>
        <translation>Lassen Sie den Tisch, wie er steht.</translation>
    </message>
    <message>
        <source>Turn the table %1 counter-clockwise, seen from above.</source>
        <translation>Drehen Sie den Tisch um %1 gegen den Uhrzeigersinn, von oben gesehen.</translation>
    </message>
    <message>
        <source>Turn the table %1 clockwise, seen from above.</source>
        <translation>Drehen Sie den Tisch um %1 im Uhrzeigersinn, von oben gesehen.</translation>
    </message>
    <message>
        <source> Then the scanner looks at the mark %1° of the table.</source>
        <translation> Dann schaut der Scanner auf die Marke %1° des Tisches.</translation>
    </message>
    <message>
        <source> Raise the scanner by %1.</source>
        <translation> Heben Sie den Scanner um %1.</translation>
    </message>
    <message>
        <source> Lower the scanner by %1.</source>
        <translation> Senken Sie den Scanner um %1.</translation>
    </message>
    <message>
        <source>Recorded scans have no next view.</source>
        <translation>Aufgezeichnete Scans haben keine nächste Ansicht.</translation>
    </message>
    <message>
        <source>No further view is proposed.</source>
        <translation>Es wird keine weitere Ansicht vorgeschlagen.</translation>
    </message>
    <message>
        <source>Position %1</source>
        <translation>Position %1</translation>
    </message>
    <message>
        <source>If you go on: position %1 shows %2</source>
        <translation>Falls Sie fortfahren: Position %1 zeigt %2</translation>
    </message>
    <message>
        <source>Position %1, your choice: shows %2</source>
        <translation>Position %1, Ihre Wahl: zeigt %2</translation>
    </message>
    <message>
        <source>Position %1, proposed: shows %2</source>
        <translation>Position %1, vorgeschlagen: zeigt %2</translation>
    </message>
    <message>
        <source>No other position was taken.</source>
        <translation>Es wurde keine andere Position genommen.</translation>
    </message>
    <message>
        <source>An earlier moment is shown; a choice holds for now.</source>
        <translation>Gezeigt wird ein früherer Zeitpunkt; eine Wahl gilt für jetzt.</translation>
    </message>
    <message>
        <source>After the first scan every position is compared here.</source>
        <translation>Nach dem ersten Scan wird hier jede Position verglichen.</translation>
    </message>
    <message>
        <source>The next scan is taken from here. </source>
        <translation>Der nächste Scan wird von hier aufgenommen. </translation>
    </message>
    <message>
        <source>It would show %1.</source>
        <translation>Sie würde %1 zeigen.</translation>
    </message>
    <message>
        <source>This is the proposed position.</source>
        <translation>Das ist die vorgeschlagene Position.</translation>
    </message>
    <message>
        <source>Shows %1 less than the proposal</source>
        <translation>Zeigt %1 weniger als der Vorschlag</translation>
    </message>
    <message>
        <source>Shows %1 more than the proposal</source>
        <translation>Zeigt %1 mehr als der Vorschlag</translation>
    </message>
    <message>
        <source>, and its overlap is %1 short: registration may fail</source>
        <translation>, und ihre Überlappung ist um %1 zu klein: Die Registrierung kann misslingen</translation>
    </message>
    <message>
        <source>, and it overlaps the model too little: registration would fail</source>
        <translation>, und sie überlappt zu wenig mit dem Modell: Die Registrierung würde misslingen</translation>
    </message>
    <message>
        <source>, and its registration would be uncertain</source>
        <translation>, und ihre Registrierung wäre unsicher</translation>
    </message>
</context>
<context>
    <name>vantage::ObjectiveView</name>
    <message>
        <source>Objective of every position</source>
        <translation>Zielfunktion jeder Position</translation>
    </message>
</context>
<context>
    <name>vantage::OtherTurnBox</name>
    <message>
        <source>Scan %1 fits another turn of the table than was said. If the table stood there:</source>
        <translation>Scan %1 passt zu einer anderen Drehung des Tisches als angegeben. Falls der Tisch dort stand:</translation>
    </message>
    <message>
        <source>It was taken at %1</source>
        <translation>Er wurde bei %1 aufgenommen</translation>
    </message>
    <message>
        <source>Take the scan as one with the table at %1, counter-clockwise from its first position, seen from above: there it fits.</source>
        <translation>Den Scan nehmen als einen mit dem Tisch bei %1, gegen den Uhrzeigersinn von seiner ersten Position, von oben gesehen: Dort passt er.</translation>
    </message>
</context>
<context>
    <name>vantage::PointPicker</name>
    <message>
        <source>Object, to pick points on</source>
        <translation>Objekt, zum Wählen von Punkten</translation>
    </message>
    <message>
        <source>Stand, to pick points on</source>
        <translation>Aufstellung, zum Wählen von Punkten</translation>
    </message>
    <message>
        <source>&amp;Remove last</source>
        <translation>&amp;Letzten entfernen</translation>
    </message>
    <message>
        <source>Takes back the point or pair that was picked last (Backspace).</source>
        <translation>Nimmt den zuletzt gewählten Punkt oder das letzte Paar zurück (Rücktaste).</translation>
    </message>
    <message>
        <source>&amp;Align from the points</source>
        <translation>&amp;Aus den Punkten ausrichten</translation>
    </message>
    <message>
        <source>The points are where the alignment begins. What it finds is checked as always.</source>
        <translation>Bei den Punkten beginnt die Ausrichtung. Was sie findet, wird geprüft wie immer.</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objekt</translation>
    </message>
    <message>
        <source>Stand</source>
        <translation>Aufstellung</translation>
    </message>
    <message>
        <source>Click place %1 on the object.</source>
        <translation>Klicken Sie auf die Stelle %1 am Objekt.</translation>
    </message>
    <message>
        <source>Click place %1 on the stand.</source>
        <translation>Klicken Sie auf die Stelle %1 an der Aufstellung.</translation>
    </message>
    <message>
        <source>Click place %1 on the object, then the same place on the stand. Three places or more are needed, far from each other.</source>
        <translation>Klicken Sie auf die Stelle %1 am Objekt, dann auf dieselbe an der Aufstellung. Drei oder mehr Stellen sind nötig, weit voneinander entfernt.</translation>
    </message>
    <message>
        <source>%1 places are picked. Align from them, or click further ones.</source>
        <translation>%1 Stellen sind gewählt. Richten Sie daraus aus, oder klicken Sie auf weitere.</translation>
    </message>
    <message>
        <source>No point was picked yet.</source>
        <translation>Es ist noch kein Punkt gewählt.</translation>
    </message>
    <message>
        <source>Three places on both are needed, %1 are picked.</source>
        <translation>Drei Stellen auf beiden sind nötig, %1 sind gewählt.</translation>
    </message>
</context>
<context>
    <name>vantage::PoseChooser</name>
    <message>
        <source>Object and stand over each other</source>
        <translation>Objekt und Aufstellung übereinander</translation>
    </message>
    <message>
        <source>&amp;Use this one</source>
        <translation>&amp;Diese verwenden</translation>
    </message>
    <message>
        <source>The stand becomes part of the model in this pose. It can be undone.</source>
        <translation>Die Aufstellung wird in dieser Pose Teil des Modells. Das kann rückgängig gemacht werden.</translation>
    </message>
    <message>
        <source>Poses that were found</source>
        <translation>Gefundene Posen</translation>
    </message>
    <message>
        <source>, in use</source>
        <translation>, in Verwendung</translation>
    </message>
    <message>
        <source>As each of them stands on the table</source>
        <translation>Wie jede von ihnen auf dem Tisch steht</translation>
    </message>
    <message>
        <source>&amp;Use it all the same</source>
        <translation>&amp;Trotzdem verwenden</translation>
    </message>
    <message>
        <source>The stand becomes part of the model although something speaks against this pose. The report says so. It can be undone.</source>
        <translation>Die Aufstellung wird Teil des Modells, obwohl etwas gegen diese Pose spricht. Der Bericht sagt es. Das kann rückgängig gemacht werden.</translation>
    </message>
    <message>
        <source>No pose was found yet.</source>
        <translation>Es wurde noch keine Pose gefunden.</translation>
    </message>
</context>
<context>
    <name>vantage::PositionalPane</name>
    <message>
        <source>Straight out</source>
        <translation>Geradeaus</translation>
    </message>
    <message>
        <source>15° to the left</source>
        <translation>15° nach links</translation>
    </message>
    <message>
        <source>15° to the right</source>
        <translation>15° nach rechts</translation>
    </message>
    <message>
        <source>15° up</source>
        <translation>15° nach oben</translation>
    </message>
    <message>
        <source>15° down</source>
        <translation>15° nach unten</translation>
    </message>
    <message>
        <source>Void, P_v</source>
        <translation>Leerraum, P_v</translation>
    </message>
    <message>
        <source>Seen, P_s</source>
        <translation>Gesehen, P_s</translation>
    </message>
    <message>
        <source>Scanner, P_c</source>
        <translation>Scanner, P_c</translation>
    </message>
    <message>
        <source>Image in positional space</source>
        <translation>Bild im Positionsraum</translation>
    </message>
    <message>
        <source>All directions</source>
        <translation>Alle Richtungen</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
</context>
<context>
    <name>vantage::PositionalSpaceView</name>
    <message>
        <source>Positional space</source>
        <translation>Positionsraum</translation>
    </message>
    <message>
        <source>The model cannot be shown: %1</source>
        <translation>Das Modell kann nicht gezeigt werden: %1</translation>
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
        <translation>Größte Öffnung, die geschlossen wird</translation>
    </message>
    <message>
        <source>Leave loose pieces out</source>
        <translation>Lose Stücke weglassen</translation>
    </message>
    <message>
        <source>Only the largest piece of the surface is written.</source>
        <translation>Nur das größte Stück der Oberfläche wird geschrieben.</translation>
    </message>
    <message>
        <source>Fewer triangles, no farther from the model than</source>
        <translation>Weniger Dreiecke, nicht weiter vom Modell als</translation>
    </message>
    <message>
        <source>The distance is measured afterwards, from both surfaces.</source>
        <translation>Der Abstand wird danach gemessen, von beiden Oberflächen aus.</translation>
    </message>
    <message>
        <source>Greatest distance from the model</source>
        <translation>Größter Abstand vom Modell</translation>
    </message>
    <message>
        <source>Only write what can be printed</source>
        <translation>Nur schreiben, was gedruckt werden kann</translation>
    </message>
    <message>
        <source>One closed surface in one piece that passes nowhere through itself. Otherwise nothing is written, and you learn why.</source>
        <translation>Eine geschlossene Oberfläche in einem Stück, die sich nirgends selbst durchdringt. Sonst wird nichts geschrieben, und Sie erfahren, warum.</translation>
    </message>
    <message>
        <source>Ready to print</source>
        <translation>Druckfertig</translation>
    </message>
    <message>
        <source>Close openings</source>
        <translation>Öffnungen schließen</translation>
    </message>
    <message>
        <source>all</source>
        <translation>alle</translation>
    </message>
    <message>
        <source>up to a width</source>
        <translation>bis zu einer Weite</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>Unit of the file</source>
        <translation>Einheit der Datei</translation>
    </message>
    <message>
        <source>millimetres</source>
        <translation>Millimeter</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>Close &amp;openings:</source>
        <translation>Ö&amp;ffnungen schließen:</translation>
    </message>
    <message>
        <source>&amp;Width:</source>
        <translation>&amp;Weite:</translation>
    </message>
    <message>
        <source>&amp;Distance:</source>
        <translation>&amp;Abstand:</translation>
    </message>
    <message>
        <source>&amp;Unit:</source>
        <translation>&amp;Einheit:</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>E&amp;xportieren…</translation>
    </message>
    <message>
        <source>What closes an opening is made up: nobody measured it. PLY and 3MF mark it; STL and OBJ cannot. The session stays as it is.</source>
        <translation>Was eine Öffnung schließt, ist erfunden: Niemand hat es gemessen. PLY und 3MF kennzeichnen es; STL und OBJ können das nicht. Die Sitzung bleibt, wie sie ist.</translation>
    </message>
</context>
<context>
    <name>vantage::RecentList</name>
    <message>
        <source>Go on with a session</source>
        <translation>Mit einer Sitzung fortfahren</translation>
    </message>
    <message>
        <source>Sessions of lately</source>
        <translation>Zuletzt geöffnete Sitzungen</translation>
    </message>
    <message>
        <source>&amp;Take off this list</source>
        <translation>Von dieser Liste &amp;nehmen</translation>
    </message>
    <message>
        <source>No session was opened yet.</source>
        <translation>Es wurde noch keine Sitzung geöffnet.</translation>
    </message>
    <message>
        <source>Open a session</source>
        <translation>Sitzung öffnen</translation>
    </message>
    <message>
        <source>%1 is gone.</source>
        <translation>%1 ist nicht mehr da.</translation>
    </message>
    <message>
        <source>There is no file %1 any more. It may have been moved, or its drive is not connected.</source>
        <translation>Die Datei %1 gibt es nicht mehr. Vielleicht wurde sie verschoben, oder ihr Laufwerk ist nicht verbunden.</translation>
    </message>
    <message>
        <source>&amp;Take off the list</source>
        <translation>Von der Liste &amp;nehmen</translation>
    </message>
</context>
<context>
    <name>vantage::RecentSessions</name>
    <message>
        <source>gone: no such file</source>
        <translation>nicht mehr da: keine solche Datei</translation>
    </message>
    <message>
        <source>open now</source>
        <translation>jetzt geöffnet</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>kann nicht gelesen werden</translation>
    </message>
    <message>
        <source>not read yet</source>
        <translation>noch nicht gelesen</translation>
    </message>
    <message>
        <source>%1
%2</source>
        <translation>%1
%2</translation>
    </message>
    <message>
        <source>changed %1</source>
        <translation>geändert %1</translation>
    </message>
</context>
<context>
    <name>vantage::RegionDrawing</name>
    <message>
        <source>Draw around what is to be erased</source>
        <translation>Umfahren, was gelöscht werden soll</translation>
    </message>
</context>
<context>
    <name>vantage::ResultWriter</name>
    <message>
        <source>Writing %1</source>
        <translation>%1 wird geschrieben</translation>
    </message>
</context>
<context>
    <name>vantage::ReviewPage</name>
    <message>
        <source>did not fit</source>
        <translation>passte nicht</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>weggelassen</translation>
    </message>
    <message>
        <source>waits</source>
        <translation>wartet</translation>
    </message>
    <message>
        <source>stand %1</source>
        <translation>Aufstellung %1</translation>
    </message>
    <message>
        <source>good</source>
        <translation>gut</translation>
    </message>
    <message>
        <source>doubtful</source>
        <translation>zweifelhaft</translation>
    </message>
    <message>
        <source>Read as: %1.</source>
        <translation>Gelesen als: %1.</translation>
    </message>
    <message>
        <source>&amp;Leave this view out</source>
        <translation>Diese Ansicht weg&amp;lassen</translation>
    </message>
    <message>
        <source>Make the model without this view, or take it back. The scan is kept.</source>
        <translation>Das Modell ohne diese Ansicht bilden, oder sie wieder aufnehmen. Der Scan bleibt erhalten.</translation>
    </message>
    <message>
        <source>T&amp;urn the object over…</source>
        <translation>&amp;Objekt wenden…</translation>
    </message>
    <message>
        <source>Put the object on another side, to scan what this stand hides.</source>
        <translation>Das Objekt auf eine andere Seite legen, um zu scannen, was diese Aufstellung verdeckt.</translation>
    </message>
    <message>
        <source>What is left, and why</source>
        <translation>Was fehlt, und warum</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>Ansichten</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>Scan</translation>
    </message>
    <message>
        <source>Pos.</source>
        <translation>Pos.</translation>
    </message>
    <message>
        <source>New mm²</source>
        <translation>Neu mm²</translation>
    </message>
    <message>
        <source>Fit mm</source>
        <translation>Güte mm</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>Choose a scan in the list first.</source>
        <translation>Wählen Sie zuerst einen Scan in der Liste.</translation>
    </message>
    <message>
        <source>&amp;Take this view back</source>
        <translation>Diese Ansicht wieder au&amp;fnehmen</translation>
    </message>
    <message>
        <source>Nothing has been scanned yet.</source>
        <translation>Es wurde noch nichts gescannt.</translation>
    </message>
    <message>
        <source>Views in this stand</source>
        <translation>Ansichten in dieser Aufstellung</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Dreiecke</translation>
    </message>
    <message>
        <source>Not known: nothing is planned from recorded scans.</source>
        <translation>Nicht bekannt: Bei aufgezeichneten Scans wird nichts geplant.</translation>
    </message>
    <message>
        <source>Of this stand alone:</source>
        <translation>Von dieser Aufstellung allein:</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>%1 mm of edge</source>
        <translation>%1 mm Rand</translation>
    </message>
    <message>
        <source>Nothing: the surface is closed.</source>
        <translation>Nichts: Die Oberfläche ist geschlossen.</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>Stand %1: </source>
        <translation>Aufstellung %1: </translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Durchsicht</translation>
    </message>
    <message>
        <source>Model and report are written where you say.</source>
        <translation>Modell und Bericht werden dorthin geschrieben, wo Sie es sagen.</translation>
    </message>
    <message>
        <source>&amp;Next: finish</source>
        <translation>&amp;Weiter: abschließen</translation>
    </message>
</context>
<context>
    <name>vantage::ScanList</name>
    <message>
        <source>Range files</source>
        <translation>Tiefendateien</translation>
    </message>
    <message>
        <source>Range file</source>
        <translation>Tiefendatei</translation>
    </message>
    <message>
        <source>Taken from position</source>
        <translation>Aufgenommen von Position</translation>
    </message>
    <message>
        <source>Add fil&amp;es…</source>
        <translation>&amp;Dateien hinzufügen…</translation>
    </message>
    <message>
        <source>Add range files; they can also be dropped here.</source>
        <translation>Tiefendateien hinzufügen; sie können auch hierher gezogen werden.</translation>
    </message>
    <message>
        <source>Range files (%1);;All files (*)</source>
        <translation>Tiefendateien (%1);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Add &amp;folder…</source>
        <translation>&amp;Ordner hinzufügen…</translation>
    </message>
    <message>
        <source>Add all range files of a folder, by name.</source>
        <translation>Alle Tiefendateien eines Ordners nach Namen hinzufügen.</translation>
    </message>
    <message>
        <source>Folder of range files</source>
        <translation>Ordner mit Tiefendateien</translation>
    </message>
    <message>
        <source>Re&amp;move</source>
        <translation>&amp;Entfernen</translation>
    </message>
    <message>
        <source>Take the chosen files off the list.</source>
        <translation>Die gewählten Dateien von der Liste nehmen.</translation>
    </message>
    <message>
        <source>&amp;Up</source>
        <translation>A&amp;uf</translation>
    </message>
    <message>
        <source>Use the chosen file earlier.</source>
        <translation>Die gewählte Datei früher verwenden.</translation>
    </message>
    <message>
        <source>&amp;Down</source>
        <translation>A&amp;b</translation>
    </message>
    <message>
        <source>Use the chosen file later.</source>
        <translation>Die gewählte Datei später verwenden.</translation>
    </message>
    <message>
        <source>Position of %1</source>
        <translation>Position von %1</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
</context>
<context>
    <name>vantage::ScannerPictureView</name>
    <message>
        <source>What the scanner would see</source>
        <translation>Was der Scanner sehen würde</translation>
    </message>
    <message>
        <source>No position chosen</source>
        <translation>Keine Position gewählt</translation>
    </message>
</context>
<context>
    <name>vantage::SectionBar</name>
    <message>
        <source>Other side</source>
        <translation>Andere Seite</translation>
    </message>
    <message>
        <source>Cut across %1</source>
        <translation>Schnitt quer zu %1</translation>
    </message>
    <message>
        <source>Axis of the cut</source>
        <translation>Achse des Schnitts</translation>
    </message>
    <message>
        <source>The axis that the plane of the cut stands across.</source>
        <translation>Die Achse, zu der die Schnittebene quer steht.</translation>
    </message>
    <message>
        <source>Place of the cut</source>
        <translation>Lage des Schnitts</translation>
    </message>
    <message>
        <source>Where the cut is; the arrow keys move it, too.</source>
        <translation>Wo der Schnitt liegt; auch die Pfeiltasten verschieben ihn.</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Place of the cut in millimetres</source>
        <translation>Lage des Schnitts in Millimetern</translation>
    </message>
    <message>
        <source>Where on the axis the cut is.</source>
        <translation>Wo auf der Achse der Schnitt liegt.</translation>
    </message>
    <message>
        <source>Take away what is below the cut, not what is above.</source>
        <translation>Wegnehmen, was unter dem Schnitt liegt, nicht was darüber liegt.</translation>
    </message>
</context>
<context>
    <name>vantage::SessionController</name>
    <message>
        <source>Preparing the set-up</source>
        <translation>Aufbau wird vorbereitet</translation>
    </message>
    <message>
        <source>Adding scans</source>
        <translation>Scans werden hinzugefügt</translation>
    </message>
    <message>
        <source>Acquiring</source>
        <translation>Aufnahme</translation>
    </message>
    <message>
        <source>Scanning</source>
        <translation>Scannen</translation>
    </message>
    <message>
        <source>Changing the session</source>
        <translation>Sitzung wird geändert</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Showing an earlier moment</source>
        <translation>Früherer Zeitpunkt wird gezeigt</translation>
    </message>
</context>
<context>
    <name>vantage::SessionDoor</name>
    <message>
        <source>Open a session to look at</source>
        <translation>Sitzung zum Ansehen öffnen</translation>
    </message>
    <message>
        <source>Open a session</source>
        <translation>Sitzung öffnen</translation>
    </message>
    <message>
        <source>Sessions (*.vantage)</source>
        <translation>Sitzungen (*.vantage)</translation>
    </message>
    <message>
        <source>%1 is open already.</source>
        <translation>%1 ist schon geöffnet.</translation>
    </message>
    <message>
        <source>You can look at it as it is now: everything is shown and can be exported, nothing is changed.</source>
        <translation>Sie können sie ansehen, wie sie jetzt ist: Alles wird gezeigt und kann exportiert werden, nichts wird geändert.</translation>
    </message>
    <message>
        <source>&amp;Open to look at</source>
        <translation>Zum &amp;Ansehen öffnen</translation>
    </message>
    <message>
        <source>Not taken</source>
        <translation>Nicht angenommen</translation>
    </message>
    <message>
        <source>%1 is a mesh. A mesh can be dropped on the first page, as what the simulated scanner looks at.</source>
        <translation>%1 ist ein Netz. Ein Netz kann auf die erste Seite gezogen werden, als das, was der simulierte Scanner betrachtet.</translation>
    </message>
    <message>
        <source>%1 is a mesh. %2</source>
        <translation>%1 ist ein Netz. %2</translation>
    </message>
    <message>
        <source>A mesh</source>
        <translation>Ein Netz</translation>
    </message>
    <message>
        <source>%1 is a mesh.</source>
        <translation>%1 ist ein Netz.</translation>
    </message>
    <message>
        <source>The simulated scanner can look at it. Its file is only read.</source>
        <translation>Der simulierte Scanner kann es betrachten. Seine Datei wird nur gelesen.</translation>
    </message>
    <message>
        <source>&amp;Scan it in simulation</source>
        <translation>In der Simulation &amp;scannen</translation>
    </message>
</context>
<context>
    <name>vantage::SessionKeeper</name>
    <message>
        <source>Opening the session</source>
        <translation>Sitzung wird geöffnet</translation>
    </message>
    <message>
        <source>Importing recorded scans</source>
        <translation>Aufgezeichnete Scans werden importiert</translation>
    </message>
</context>
<context>
    <name>vantage::SessionLog</name>
    <message>
        <source>Written: %1</source>
        <translation>Geschrieben: %1</translation>
    </message>
    <message>
        <source>Session: %1</source>
        <translation>Sitzung: %1</translation>
    </message>
    <message>
        <source>Opened after %1 steps; the last one: %2</source>
        <translation>Nach %1 Schritten geöffnet; der letzte: %2</translation>
    </message>
    <message>
        <source>Undone: %1</source>
        <translation>Rückgängig gemacht: %1</translation>
    </message>
    <message>
        <source>Redone: %1</source>
        <translation>Wiederholt: %1</translation>
    </message>
</context>
<context>
    <name>vantage::SessionViews</name>
    <message>
        <source>This is the session as it was after view %1. Back to now</source>
        <translation>Das ist die Sitzung, wie sie nach Ansicht %1 war. Zurück zu jetzt</translation>
    </message>
</context>
<context>
    <name>vantage::SettingsDialog</name>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>The window speaks it after it was closed and opened again.</source>
        <translation>Das Fenster spricht sie, nachdem es geschlossen und wieder geöffnet wurde.</translation>
    </message>
</context>
<context>
    <name>vantage::SettingsForm</name>
    <message>
        <source>Options for experts</source>
        <translation>Optionen für Experten</translation>
    </message>
    <message>
        <source>Show the options of every operation.</source>
        <translation>Die Optionen jeder Operation zeigen.</translation>
    </message>
    <message>
        <source>Load options…</source>
        <translation>Optionen laden…</translation>
    </message>
    <message>
        <source>Take all options from a file that was saved before.</source>
        <translation>Alle Optionen aus einer früher gespeicherten Datei nehmen.</translation>
    </message>
    <message>
        <source>Save options…</source>
        <translation>Optionen speichern…</translation>
    </message>
    <message>
        <source>Keep all options in a file, for here and for the command line.</source>
        <translation>Alle Optionen in einer Datei aufbewahren, für hier und für die Kommandozeile.</translation>
    </message>
    <message>
        <source>Load options</source>
        <translation>Optionen laden</translation>
    </message>
    <message>
        <source>Options (*.json)</source>
        <translation>Optionen (*.json)</translation>
    </message>
    <message>
        <source>Save options</source>
        <translation>Optionen speichern</translation>
    </message>
</context>
<context>
    <name>vantage::StandBox</name>
    <message>
        <source>Align no&amp;w</source>
        <translation>&amp;Jetzt ausrichten</translation>
    </message>
    <message>
        <source>Find out how the object stands from what has been scanned of it so far.</source>
        <translation>Aus dem bisher Gescannten ermitteln, wie das Objekt steht.</translation>
    </message>
    <message>
        <source>Compare poses…</source>
        <translation>Posen vergleichen…</translation>
    </message>
    <message>
        <source>See the stand over the object in every pose that was found, choose one, or pick points.</source>
        <translation>Die Aufstellung in jeder gefundenen Pose über dem Objekt ansehen, eine wählen, oder Punkte wählen.</translation>
    </message>
    <message>
        <source>Turn again…</source>
        <translation>Noch einmal wenden…</translation>
    </message>
    <message>
        <source>Put the object on another side. The scans of this stand are kept, and tried again then.</source>
        <translation>Das Objekt auf eine andere Seite legen. Die Scans dieser Aufstellung bleiben erhalten und werden dann noch einmal versucht.</translation>
    </message>
    <message>
        <source>Undo this stand: what was scanned in it is left, and can be redone. To scan on then, the object has to stand as if it had never been moved; else turn it over again.</source>
        <translation>Diese Aufstellung rückgängig machen: Was darin gescannt wurde, fällt weg und kann wiederholt werden. Um dann weiter zu scannen, muss das Objekt stehen, als wäre es nie bewegt worden; sonst wenden Sie es noch einmal.</translation>
    </message>
    <message>
        <source>Bac&amp;k to one stand</source>
        <translation>Zurü&amp;ck zu einer Aufstellung</translation>
    </message>
    <message>
        <source>Bac&amp;k to %1 stands</source>
        <translation>Zurü&amp;ck zu %1 Aufstellungen</translation>
    </message>
</context>
<context>
    <name>vantage::StandDesk</name>
    <message>
        <source>Looking for sides to put the object on</source>
        <translation>Suche nach Seiten, auf die das Objekt gelegt werden kann</translation>
    </message>
    <message>
        <source>It was stopped.</source>
        <translation>Es wurde angehalten.</translation>
    </message>
    <message>
        <source>From its third view on that is tried after every scan.</source>
        <translation>Ab ihrer dritten Ansicht wird das nach jedem Scan versucht.</translation>
    </message>
    <message>
        <source>The object stands as it did at first.</source>
        <translation>Das Objekt steht wie am Anfang.</translation>
    </message>
</context>
<context>
    <name>vantage::StandDialog</name>
    <message>
        <source>&amp;Look for poses</source>
        <translation>&amp;Nach Posen suchen</translation>
    </message>
    <message>
        <source>Searches all turns for poses of this stand, and checks them against the scans.</source>
        <translation>Sucht alle Drehungen nach Posen dieser Aufstellung ab und prüft sie an den Scans.</translation>
    </message>
    <message>
        <source>&amp;Pick points…</source>
        <translation>&amp;Punkte wählen…</translation>
    </message>
    <message>
        <source>Click the same places on object and stand, where no pose is found without them.</source>
        <translation>Klicken Sie auf dieselben Stellen an Objekt und Aufstellung, wo ohne sie keine Pose gefunden wird.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Closes this window.</source>
        <translation>Schließt dieses Fenster.</translation>
    </message>
    <message>
        <source>How the stands lie in each other</source>
        <translation>Lage der Aufstellungen zueinander</translation>
    </message>
    <message>
        <source>Stand %1</source>
        <translation>Aufstellung %1</translation>
    </message>
    <message>
        <source>Stand that is not in place yet</source>
        <translation>Aufstellung, die noch nicht eingefügt ist</translation>
    </message>
    <message>
        <source>&amp;Back to the poses</source>
        <translation>&amp;Zurück zu den Posen</translation>
    </message>
    <message>
        <source>Looking at the points</source>
        <translation>Die Punkte werden betrachtet</translation>
    </message>
    <message>
        <source>Something else is under way.</source>
        <translation>Etwas anderes läuft gerade.</translation>
    </message>
    <message>
        <source>The stand is in place already. Undo the step to choose again.</source>
        <translation>Die Aufstellung ist schon eingefügt. Machen Sie den Schritt rückgängig, um neu zu wählen.</translation>
    </message>
    <message>
        <source>The stand is not ready to be looked at yet.</source>
        <translation>Die Aufstellung kann noch nicht angesehen werden.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
</context>
<context>
    <name>vantage::StandInspector</name>
    <message>
        <source>Comparing stand %1 with the object</source>
        <translation>Aufstellung %1 wird mit dem Objekt verglichen</translation>
    </message>
    <message>
        <source>Stopped. Open this window again to look at the stand.</source>
        <translation>Angehalten. Öffnen Sie dieses Fenster erneut, um die Aufstellung anzusehen.</translation>
    </message>
    <message>
        <source>Looking at the poses</source>
        <translation>Die Posen werden betrachtet</translation>
    </message>
</context>
<context>
    <name>vantage::StandSides</name>
    <message>
        <source>Sides that the object can rest on, the best first</source>
        <translation>Seiten, auf denen das Objekt liegen kann, die beste zuerst</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1 · again</source>
        <translation>%1 · erneut</translation>
    </message>
    <message>
        <source>%1 of what is still unseen, %2 of what is left. It tilts by %3 before it falls over.</source>
        <translation>%1 des noch Ungesehenen, %2 dessen, was fehlt. Es lässt sich um %3 kippen, bevor es umfällt.</translation>
    </message>
    <message>
        <source>It stood like this already.</source>
        <translation>So lag es schon.</translation>
    </message>
</context>
<context>
    <name>vantage::StandStrip</name>
    <message>
        <source>Stands of the object</source>
        <translation>Aufstellungen des Objekts</translation>
    </message>
    <message>
        <source>Stand %1 · %2</source>
        <translation>Aufstellung %1 · %2</translation>
    </message>
    <message>
        <source>%1 (undone)</source>
        <translation>%1 (rückgängig gemacht)</translation>
    </message>
    <message>
        <source>Stand %1</source>
        <translation>Aufstellung %1</translation>
    </message>
</context>
<context>
    <name>vantage::StandView</name>
    <message>
        <source>The object as it would stand</source>
        <translation>Das Objekt, wie es stehen würde</translation>
    </message>
</context>
<context>
    <name>vantage::TableCalibrating</name>
    <message>
        <source>Something else is under way.</source>
        <translation>Etwas anderes läuft gerade.</translation>
    </message>
    <message>
        <source>Scanner and object are not read yet.</source>
        <translation>Scanner und Objekt sind noch nicht gelesen.</translation>
    </message>
    <message>
        <source>A simulated table needs no calibration.</source>
        <translation>Ein simulierter Tisch braucht keine Kalibrierung.</translation>
    </message>
    <message>
        <source>Only a table that turns by itself has an angle that can be calibrated.</source>
        <translation>Nur ein Tisch, der selbst dreht, hat einen Winkel, der kalibriert werden kann.</translation>
    </message>
    <message>
        <source>Calibrating the table</source>
        <translation>Der Drehtisch wird kalibriert</translation>
    </message>
    <message>
        <source>Writing the calibration</source>
        <translation>Die Kalibrierung wird geschrieben</translation>
    </message>
</context>
<context>
    <name>vantage::TestScanBox</name>
    <message>
        <source>Take &amp;a test scan</source>
        <translation>P&amp;robescan</translation>
    </message>
    <message>
        <source>Scan once from the first position and look at what is used of it. The scan is not kept.</source>
        <translation>Einmal von der ersten Position scannen und ansehen, was davon verwendet wird. Der Scan wird nicht behalten.</translation>
    </message>
    <message>
        <source>The session that is open keeps what it was begun with.</source>
        <translation>Die geöffnete Sitzung behält, womit sie begonnen wurde.</translation>
    </message>
    <message>
        <source>A test scan shows what the scanner sees, and what of that is taken for the object.</source>
        <translation>Ein Probescan zeigt, was der Scanner sieht und was davon als Objekt gilt.</translation>
    </message>
    <message>
        <source>Nothing of the scan is used: look whether the object stands inside the viewing volume, and whether too much is cut.</source>
        <translation>Von dem Scan wird nichts verwendet: Prüfen Sie, ob das Objekt im Messvolumen steht und ob zu viel ausgeschnitten wird.</translation>
    </message>
    <message>
        <source>1 sample</source>
        <translation>1 Messpunkt</translation>
    </message>
    <message>
        <source>%1 samples</source>
        <translation>%1 Messpunkte</translation>
    </message>
</context>
<context>
    <name>vantage::TestScans</name>
    <message>
        <source>Test turn</source>
        <translation>Probedrehung</translation>
    </message>
    <message>
        <source>Test scan</source>
        <translation>Probescan</translation>
    </message>
</context>
<context>
    <name>vantage::TimeLine</name>
    <message>
        <source>Moments of the session</source>
        <translation>Zeitpunkte der Sitzung</translation>
    </message>
    <message>
        <source>%1 (undone)</source>
        <translation>%1 (rückgängig gemacht)</translation>
    </message>
</context>
<context>
    <name>vantage::ToolBar</name>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
</context>
<context>
    <name>vantage::TurnDial</name>
    <message>
        <source>Turn the table by %1</source>
        <translation>Drehen Sie den Tisch um %1</translation>
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
        <translation>&amp;Erneut suchen</translation>
    </message>
    <message>
        <source>Look for sides to put the object on.</source>
        <translation>Nach Seiten suchen, auf die das Objekt gelegt werden kann.</translation>
    </message>
    <message>
        <source>Sides that it can rest on</source>
        <translation>Seiten, auf denen es liegen kann</translation>
    </message>
    <message>
        <source>It s&amp;tands on this side now: scan on</source>
        <translation>Es liegt jetzt a&amp;uf dieser Seite: weiter scannen</translation>
    </message>
    <message>
        <source>Begin a new stand. What was scanned before is kept aside until it is known how the object was turned over.</source>
        <translation>Eine neue Aufstellung beginnen. Was davor gescannt wurde, wird beiseitegelegt, bis bekannt ist, wie das Objekt gewendet wurde.</translation>
    </message>
    <message>
        <source>Scan on, or go to the review without. How it was turned over is found out by itself.</source>
        <translation>Scannen Sie weiter, oder gehen Sie ohne sie zur Durchsicht. Wie es gewendet wurde, wird von selbst ermittelt.</translation>
    </message>
    <message>
        <source>Looking for the side that would show most.</source>
        <translation>Die Seite, die am meisten zeigen würde, wird gesucht.</translation>
    </message>
    <message>
        <source>Nothing is known of its sides yet.</source>
        <translation>Über seine Seiten ist noch nichts bekannt.</translation>
    </message>
    <message>
        <source>Nothing has been scanned yet.</source>
        <translation>Es wurde noch nichts gescannt.</translation>
    </message>
    <message>
        <source>There is no model of the object: nothing can be said of its sides.</source>
        <translation>Es gibt kein Modell des Objekts: Über seine Seiten lässt sich nichts sagen.</translation>
    </message>
    <message>
        <source>What is known of the object spans no volume, so it is not known what it can rest on. Scan more first.</source>
        <translation>Was vom Objekt bekannt ist, umfasst kein Volumen, daher ist nicht bekannt, worauf es liegen kann. Scannen Sie zuerst mehr.</translation>
    </message>
    <message>
        <source>Nothing is left that another stand could show: the surface is closed.</source>
        <translation>Nichts fehlt, das eine andere Aufstellung zeigen könnte: Die Oberfläche ist geschlossen.</translation>
    </message>
    <message>
        <source>Nothing more is to be gained: no other side would show more than %1, which a stand has to be worth. %2 of what is still unseen no side shows at all: it lies in hollows or too steep from everywhere.</source>
        <translation>Mehr ist nicht zu gewinnen: Keine andere Seite würde mehr als %1 zeigen, was eine Aufstellung wert sein muss. %2 des noch Ungesehenen zeigt gar keine Seite: Es liegt in Höhlungen oder ist von überall zu steil.</translation>
    </message>
    <message>
        <source>On another side the scanner would see up to %1 of what is still unseen, %2 of what is left.</source>
        <translation>Auf einer anderen Seite würde der Scanner bis zu %1 des noch Ungesehenen sehen, %2 dessen, was fehlt.</translation>
    </message>
    <message>
        <source>The simulated object is turned over by itself: it comes to rest on the side nearest to this one, turned at random and a little beside the axis.</source>
        <translation>Das simulierte Objekt wird von selbst gewendet: Es kommt auf der Seite zu liegen, die dieser am nächsten ist, zufällig gedreht und ein wenig neben der Achse.</translation>
    </message>
    <message>
        <source>Put it on that side anywhere near the axis, turned in any way: how it stands is found out.</source>
        <translation>Legen Sie es irgendwo nahe der Achse auf diese Seite, beliebig gedreht: Wie es steht, wird ermittelt.</translation>
    </message>
    <message>
        <source>If it would not rest like this, take the picture that is nearest to how it does.</source>
        <translation>Falls es so nicht liegen bleibt, nehmen Sie das Bild, das dem am nächsten kommt, wie es liegt.</translation>
    </message>
    <message>
        <source>What holds it is scanned with it, save what lies at the height of the table, which is cut out: hold it with as little as will do.</source>
        <translation>Was es hält, wird mitgescannt, außer dem, was in der Höhe des Tisches liegt; das wird ausgeschnitten: Halten Sie es mit so wenig wie möglich.</translation>
    </message>
    <message>
        <source>What holds it is scanned with it, and so is the table: nothing is cut out of these scans.</source>
        <translation>Was es hält, wird mitgescannt, und der Tisch ebenso: Aus diesen Scans wird nichts ausgeschnitten.</translation>
    </message>
    <message>
        <source>Something else is under way.</source>
        <translation>Etwas anderes läuft gerade.</translation>
    </message>
    <message>
        <source>There is no side to put it on yet.</source>
        <translation>Es gibt noch keine Seite, auf die es gelegt werden kann.</translation>
    </message>
    <message>
        <source>It would show</source>
        <translation>Es würde zeigen</translation>
    </message>
    <message>
        <source>%1 of what is left</source>
        <translation>%1 dessen, was fehlt</translation>
    </message>
    <message>
        <source>It falls over beyond a tilt of</source>
        <translation>Kippt um ab einer Neigung von</translation>
    </message>
    <message>
        <source>easily: hold it, or take another side</source>
        <translation>leicht: Halten Sie es, oder nehmen Sie eine andere Seite</translation>
    </message>
    <message>
        <source>It stood like this</source>
        <translation>So lag es</translation>
    </message>
    <message>
        <source>already</source>
        <translation>schon</translation>
    </message>
    <message>
        <source>Turn the object over</source>
        <translation>Objekt wenden</translation>
    </message>
    <message>
        <source>&amp;Next: review</source>
        <translation>&amp;Weiter: Durchsicht</translation>
    </message>
</context>
<context>
    <name>vantage::Undertaking</name>
    <message>
        <source>Nothing runs that could pause.</source>
        <translation>Es läuft nichts, das pausieren könnte.</translation>
    </message>
    <message>
        <source>Nothing runs that could be stopped.</source>
        <translation>Es läuft nichts, das angehalten werden könnte.</translation>
    </message>
    <message>
        <source>%1: stopped</source>
        <translation>%1: angehalten</translation>
    </message>
</context>
<context>
    <name>vantage::UnrolledMapView</name>
    <message>
        <source>Positional space, unrolled</source>
        <translation>Positionsraum, abgewickelt</translation>
    </message>
    <message>
        <source>No plan yet</source>
        <translation>Noch kein Plan</translation>
    </message>
</context>
<context>
    <name>vantage::ViewActions</name>
    <message>
        <source>Measure anew</source>
        <translation>Neu messen</translation>
    </message>
    <message>
        <source>Forgets both places.</source>
        <translation>Vergisst beide Stellen.</translation>
    </message>
    <message>
        <source>&amp;Wireframe</source>
        <translation>&amp;Drahtgitter</translation>
    </message>
    <message>
        <source>Ctrl+Shift+W</source>
        <translation>Ctrl+Shift+W</translation>
    </message>
    <message>
        <source>Only the edges of the triangles</source>
        <translation>Nur die Kanten der Dreiecke</translation>
    </message>
    <message>
        <source>&amp;Points</source>
        <translation>&amp;Punkte</translation>
    </message>
    <message>
        <source>Ctrl+Shift+P</source>
        <translation>Ctrl+Shift+P</translation>
    </message>
    <message>
        <source>Only the corners of the triangles</source>
        <translation>Nur die Ecken der Dreiecke</translation>
    </message>
    <message>
        <source>&amp;Back faces in red</source>
        <translation>&amp;Rückseiten in Rot</translation>
    </message>
    <message>
        <source>Ctrl+Shift+B</source>
        <translation>Ctrl+Shift+B</translation>
    </message>
    <message>
        <source>Where a surface is seen from its inside</source>
        <translation>Wo eine Oberfläche von innen gesehen wird</translation>
    </message>
    <message>
        <source>Parallel p&amp;rojection</source>
        <translation>Para&amp;llelprojektion</translation>
    </message>
    <message>
        <source>Ctrl+Shift+G</source>
        <translation>Ctrl+Shift+G</translation>
    </message>
    <message>
        <source>What is far is as large as what is near</source>
        <translation>Fernes ist so groß wie Nahes</translation>
    </message>
    <message>
        <source>&amp;Cut by a plane</source>
        <translation>Mit einer Ebene &amp;schneiden</translation>
    </message>
    <message>
        <source>Ctrl+Shift+X</source>
        <translation>Ctrl+Shift+X</translation>
    </message>
    <message>
        <source>Takes away what is on one side of a plane</source>
        <translation>Nimmt weg, was auf einer Seite einer Ebene liegt</translation>
    </message>
    <message>
        <source>&amp;Measure between two places</source>
        <translation>Zwischen zwei Stellen &amp;messen</translation>
    </message>
    <message>
        <source>Ctrl+M</source>
        <translation>Ctrl+M</translation>
    </message>
    <message>
        <source>Click two places on the surface</source>
        <translation>Auf zwei Stellen der Oberfläche klicken</translation>
    </message>
    <message>
        <source>From 1 to 2: %1</source>
        <translation>Von 1 bis 2: %1</translation>
    </message>
    <message>
        <source>Click the first place on the surface.</source>
        <translation>Klicken Sie auf die erste Stelle der Oberfläche.</translation>
    </message>
    <message>
        <source>Click the second place on the surface.</source>
        <translation>Klicken Sie auf die zweite Stelle der Oberfläche.</translation>
    </message>
    <message>
        <source>Nothing was measured yet.</source>
        <translation>Es wurde noch nichts gemessen.</translation>
    </message>
</context>
<context>
    <name>vantage::VolumeSketch</name>
    <message>
        <source>Object in the viewing volume</source>
        <translation>Objekt im Messvolumen</translation>
    </message>
    <message>
        <source>⌀ %1 mm, %2 mm high</source>
        <translation>⌀ %1 mm, %2 mm hoch</translation>
    </message>
</context>
<context>
    <name>vantage::WhyPanel</name>
    <message>
        <source>Unseen edges from there</source>
        <translation>Ungesehene Ränder von dort</translation>
    </message>
    <message>
        <source>No position yet</source>
        <translation>Noch keine Position</translation>
    </message>
    <message>
        <source>Once a view is planned it is explained here. Click any position in the objective to ask why it was not proposed.</source>
        <translation>Sobald eine Ansicht geplant ist, wird sie hier erklärt. Klicken Sie in der Zielfunktion auf eine beliebige Position, um zu fragen, warum sie nicht vorgeschlagen wurde.</translation>
    </message>
    <message>
        <source>What the scanner would see from %1</source>
        <translation>Was der Scanner von %1 aus sehen würde</translation>
    </message>
</context>
<context>
    <name>vantage::Wizard</name>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Zurück</translation>
    </message>
    <message>
        <source>The page before; nothing is lost.</source>
        <translation>Die Seite davor; nichts geht verloren.</translation>
    </message>
    <message>
        <source>What happens next</source>
        <translation>Was als Nächstes geschieht</translation>
    </message>
    <message>
        <source>Step %1 of %2</source>
        <translation>Schritt %1 von %2</translation>
    </message>
    <message>
        <source>Between step %1 and step %2 of %3</source>
        <translation>Zwischen Schritt %1 und Schritt %2 von %3</translation>
    </message>
    <message>
        <source>This is the first page.</source>
        <translation>Das ist die erste Seite.</translation>
    </message>
</context>
<context>
    <name>vantage::WizardPage</name>
    <message>
        <source>Something else is under way.</source>
        <translation>Etwas anderes läuft gerade.</translation>
    </message>
    <message>
        <source>Nothing has been scanned yet.</source>
        <translation>Es wurde noch nichts gescannt.</translation>
    </message>
    <message>
        <source>Scanner and object are not read yet.</source>
        <translation>Scanner und Objekt sind noch nicht gelesen.</translation>
    </message>
    <message>
        <source>E&amp;rase what is not the object…</source>
        <translation>Löschen, was nicht zu&amp;m Objekt gehört…</translation>
    </message>
    <message>
        <source>Take putty, a clamp, the table or loose pieces out of the model.</source>
        <translation>Knete, eine Klemme, den Tisch oder lose Stücke aus dem Modell nehmen.</translation>
    </message>
    <message>
        <source>An earlier moment is shown: go back to now first.</source>
        <translation>Gezeigt wird ein früherer Zeitpunkt: Gehen Sie zuerst zurück zu jetzt.</translation>
    </message>
</context>
</TS>
