# Read by cpack: what the packages are called, what they need, and what they say of themselves. The version is known here
# only: cpack -D CPACK_PACKAGE_VERSION=... makes packages of another one.
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(same "(= ${CPACK_PACKAGE_VERSION})")

set(about
"Vantage takes range images of an object from positions around it, registers and
integrates them into one model, works out where the surface is still unknown,
and chooses the position from which the next scan shows most of it. It stops
when nothing is left that any position could see.
.
")

# The first line of each description is the synopsis, not that of the project.
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")

set(CPACK_DEBIAN_WINDOW_PACKAGE_NAME vantage)
set(CPACK_DEBIAN_WINDOW_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_WINDOW_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_WINDOW_PACKAGE_DEPENDS "vantage-data ${same}")
set(CPACK_DEBIAN_WINDOW_PACKAGE_RECOMMENDS "vantage-cli ${same}, libgl1-mesa-dri, fonts-dejavu-core, qt6-translations-l10n")
set(CPACK_DEBIAN_WINDOW_PACKAGE_SUGGESTS "vantage-doc, qt6-wayland, fonts-noto-cjk | fonts-droid-fallback")
set(CPACK_DEBIAN_WINDOW_DESCRIPTION
"scanning workstation that decides where to scan next
${about}This package has the window, and the program that draws pictures for the
command line.")

set(CPACK_DEBIAN_CLI_PACKAGE_NAME vantage-cli)
set(CPACK_DEBIAN_CLI_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_CLI_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_CLI_PACKAGE_DEPENDS "vantage-data ${same}")
set(CPACK_DEBIAN_CLI_PACKAGE_SUGGESTS "vantage ${same}, vantage-doc")
set(CPACK_DEBIAN_CLI_DESCRIPTION
"command line of the scanning workstation Vantage
${about}This package has the command line, which needs no graphics: neither Qt nor
OpenGL. Pictures of sessions and in reports are drawn where the package vantage
is installed as well.")

set(CPACK_DEBIAN_DATA_PACKAGE_NAME vantage-data)
set(CPACK_DEBIAN_DATA_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_DATA_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_DATA_DESCRIPTION
"scanners, turntables and sample objects of Vantage
${about}This package has profiles of scanners and turntables, sample objects for the
simulated scanners, the manual that the window shows, and the rules that let
whoever sits at the machine use turntables and depth cameras.")

set(CPACK_DEBIAN_DOC_PACKAGE_NAME vantage-doc)
set(CPACK_DEBIAN_DOC_PACKAGE_SECTION doc)
set(CPACK_DEBIAN_DOC_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_DOC_PACKAGE_DEPENDS "vantage-data ${same}")
set(CPACK_DEBIAN_DOC_DESCRIPTION
"manual of the scanning workstation Vantage
${about}This package has the manual among the documents: for operators, and on devices,
calibration, stands, colours, batches.")
