package org.robotui.architecture.tests;

import java.nio.file.Files;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The window does not wait for core and for components at its start, so the product gives them a later start level. */
final class StartLevelRule implements Rule {

  private static final String PRODUCT = "product/org.robotui.workbench.product";

  private static final Pattern LATER = Pattern.compile("<plugin\\s+id=\"([^\"]+)\"\\s+autoStart=\"false\"\\s+startLevel=\"5\"");

  private static final Pattern COMPONENTS = Pattern.compile("org\\.robotui\\.(core|(rfic|uic|ruic)\\..+)");

  private static final Pattern APPLICATIONS = Pattern.compile("org\\.robotui\\.(workbench|headless)");

  @Override
  public String statement() {
    return "core and all components start beside the window, at level 5 of the product";
  }

  @Override
  public Stream<Violation> violations(Repository repository) {
    if (!Files.exists(repository.root().resolve(PRODUCT))) {
      return Stream.empty();
    }
    Set<String> later = LATER.matcher(repository.read(PRODUCT)).results().map(found -> found.group(1)).collect(Collectors.toSet());
    return repository.bundles().stream().filter(bundle -> hasComponents(bundle) != later.contains(bundle.name())).map(Bundle::name)
        .map(name -> new Violation(name, later.contains(name)
            ? "is no component, but starts beside the window (" + PRODUCT + ")"
            : "has no startLevel=\"5\" in " + PRODUCT + ": the window would wait for it"));
  }

  private static boolean hasComponents(Bundle bundle) {
    return COMPONENTS.matcher(bundle.name()).matches()
        || LazyComponentsRule.hasComponents(bundle) && !APPLICATIONS.matcher(bundle.name()).matches();
  }
}
