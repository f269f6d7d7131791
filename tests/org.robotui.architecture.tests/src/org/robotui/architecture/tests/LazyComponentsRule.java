package org.robotui.architecture.tests;

import java.util.regex.Pattern;
import java.util.stream.Stream;

/** The product starts no bundle by name: lazy activation is what lets declarative services see its components. */
final class LazyComponentsRule implements Rule {

  private static final Pattern COMPONENT = Pattern.compile("^@Component\\b", Pattern.MULTILINE);

  @Override
  public String statement() {
    return "a bundle with declarative services components is activated lazily";
  }

  @Override
  public Stream<Violation> violations(Repository repository) {
    return repository.bundles().stream()
        .filter(LazyComponentsRule::hasComponents)
        .filter(bundle -> !bundle.manifest().header("Bundle-ActivationPolicy").startsWith("lazy"))
        .map(bundle -> new Violation(bundle.name() + "/META-INF/MANIFEST.MF",
            "has components, but no \"Bundle-ActivationPolicy: lazy\": they would never be found"));
  }

  static boolean hasComponents(Bundle bundle) {
    return bundle.sources().stream().anyMatch(source -> COMPONENT.matcher(source.text()).find());
  }
}
