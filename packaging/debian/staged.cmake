# Run by cpack once all is staged, one folder per component, before the packages are made of it.
cmake_policy(SET CMP0057 NEW)
find_program(GZIP gzip REQUIRED)

set(window_package vantage)
set(cli_package vantage-cli)
set(data_package vantage-data)
set(doc_package vantage-doc)

function(compress file)
  execute_process(COMMAND ${GZIP} -9nf ${file} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

foreach(component IN LISTS CPACK_COMPONENTS_ALL)
  set(root ${CPACK_TEMPORARY_DIRECTORY}/${component})
  set(doc ${root}/usr/share/doc/${${component}_package})
  file(COPY ${CPACK_VANTAGE_DEBIAN_FOLDER}/copyright DESTINATION ${doc}
    FILE_PERMISSIONS OWNER_READ OWNER_WRITE GROUP_READ WORLD_READ)
  configure_file(${CPACK_VANTAGE_DEBIAN_FOLDER}/changelog ${doc}/changelog @ONLY)
  compress(${doc}/changelog)
  file(GLOB_RECURSE pages ${root}/usr/share/man/*.1)
  foreach(page IN LISTS pages)
    compress(${page})
  endforeach()
  file(GLOB_RECURSE overrides ${CPACK_VANTAGE_DEBIAN_FOLDER}/${${component}_package}.lintian-overrides)
  if(overrides)
    file(COPY ${overrides} DESTINATION ${root}/usr/share/lintian/overrides)
    file(RENAME ${root}/usr/share/lintian/overrides/${${component}_package}.lintian-overrides
      ${root}/usr/share/lintian/overrides/${${component}_package})
  endif()
  execute_process(COMMAND chmod -R u=rwX,go=rX ${root} COMMAND_ERROR_IS_FATAL ANY)
  # Packages of the same commit have the same bytes, whenever they are made.
  if(DEFINED ENV{SOURCE_DATE_EPOCH})
    execute_process(COMMAND find ${root} -exec touch --no-dereference --date=@$ENV{SOURCE_DATE_EPOCH} {} +
      COMMAND_ERROR_IS_FATAL ANY)
  endif()
endforeach()
