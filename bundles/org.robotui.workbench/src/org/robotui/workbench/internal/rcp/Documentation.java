package org.robotui.workbench.internal.rcp;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Predicate;

/** The pages that a product brings along, for a browser. */
final class Documentation {
  private static final String FOLDER = "documentation";
  private static final String VIEWS = "docs/views/";

  private final Path folder;
  private final Predicate<String> launcher;

  /**
   * That of an installation.
   *
   * @param installation the folder of the product
   * @param launcher has a program of the system show what an address names; false where there is none
   */
  Documentation(Path installation, Predicate<String> launcher) {
    this.folder = installation.resolve(FOLDER);
    this.launcher = launcher;
  }

  /** The page that leads to all others. */
  Path index() {
    return folder.resolve("index.html");
  }

  /** The page about a type of view; none for one that comes without, as from somebody else. */
  Optional<Path> view(String type) {
    return Optional.of(folder.resolve(VIEWS + type + ".html"))
        .filter(page -> type.matches("[a-z0-9]+") && Files.isReadable(page));
  }

  /**
   * Shows a page in the browser.
   *
   * @param page one of the pages
   * @return what is to be said where it cannot be shown
   */
  Optional<String> open(Path page) {
    if (!Files.isReadable(page)) {
      return Optional.of("The documentation is not in this installation: " + page + " is missing.");
    }
    return launcher.test(page.toUri().toString()) ? Optional.empty()
        : Optional.of("No program of this system shows web pages. The documentation is in\n" + page);
  }
}
