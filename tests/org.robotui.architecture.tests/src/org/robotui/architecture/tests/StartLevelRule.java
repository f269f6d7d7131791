package org.robotui.architecture.tests;

import java.nio.file.Files;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * The window does not wait for core, components and what components draw at its start, so the product gives them a
 * later start level. It names them by what their ids begin with: a bundle that it named itself could not be taken out
 * of it.
 */
final class StartLevelRule implements Rule {

  private static final String LATER = "product/org.robotui.workbench.p2.inf";

  private static final String PRODUCT = "product/org.robotui.workbench.product";

  private static final Pattern PATTERN = Pattern.compile("id ~= /([^/]+)/");

  private static final Pattern NAMED = Pattern.compile("<plugin\\s+id=\"(org\\.robotui\\.[^\"]+)\"");

  private static final Pattern COMPONENTS = Pattern.compile("org\\.robotui\\.(core|(entity|rfic|uic|ruic)\\..+)");

  private static final Pattern APPLICATIONS = Pattern.compile("org\\.robotui\\.(workbench|headless)");

  @Override
  public String statement() {
    return "core and all components start beside the window, and none of them is named by the product";
  }

  @Override
  public Stream<Violation> violations(Repository repository) {
    if (!Files.exists(repository.root().resolve(LATER))) {
      return Stream.empty();
    }
    List<Pattern> later = PATTERN.matcher(repository.read(LATER)).results().map(found -> glob(found.group(1))).toList();
    Stream<Violation> levels =
        repository.bundles().stream().filter(bundle -> hasComponents(bundle) != isLater(bundle, later))
            .map(bundle -> new Violation(bundle.name(), isLater(bundle, later)
                ? "is no component, but starts beside the window (" + LATER + ")"
                : "has no start level in " + LATER + ": the window would wait for it"));
    return Stream.concat(levels, named(repository));
  }

  private static Stream<Violation> named(Repository repository) {
    if (!Files.exists(repository.root().resolve(PRODUCT))) {
      return Stream.empty();
    }
    return NAMED.matcher(repository.read(PRODUCT)).results()
        .map(
            found -> new Violation(PRODUCT, "names " + found.group(1) + ", whose feature could then not be taken out"));
  }

  private static boolean isLater(Bundle bundle, List<Pattern> later) {
    return later.stream().anyMatch(pattern -> pattern.matcher(bundle.name()).matches());
  }

  private static Pattern glob(String text) {
    return Pattern.compile(text.replace(".", "\\.").replace("*", ".*"));
  }

  private static boolean hasComponents(Bundle bundle) {
    return COMPONENTS.matcher(bundle.name()).matches()
        || LazyComponentsRule.hasComponents(bundle) && !APPLICATIONS.matcher(bundle.name()).matches();
  }
}
