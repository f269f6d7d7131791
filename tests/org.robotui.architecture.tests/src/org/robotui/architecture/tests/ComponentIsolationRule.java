package org.robotui.architecture.tests;

import java.util.List;
import java.util.stream.Stream;

/** RFICs, UICs and RUICs know each other by type id only; a RUIC knows no entity either. */
final class ComponentIsolationRule implements Rule {

  private static final List<String> COMPONENTS =
      List.of("org.robotui.rfic.*", "org.robotui.uic.*", "org.robotui.ruic.*");
  private static final List<String> HIDDEN_FROM_RUICS =
      List.of("org.robotui.entity.*", "org.robotui.ui", "org.robotui.gl", "org.robotui.core");

  @Override
  public String statement() {
    return "RFICs, UICs and RUICs never import each other";
  }

  @Override
  public Stream<Violation> violations(Repository repository) {
    return repository.bundles().stream()
        .filter(bundle -> isOneOf(COMPONENTS, bundle))
        .flatMap(bundle -> Uses.of(bundle).flatMap(use -> repository.owner(use.name()).stream()
            .filter(other -> !other.name().equals(bundle.name()))
            .filter(other -> isHidden(other, bundle))
            .map(other -> new Violation(use.where(), "uses " + use.name() + " of the component " + other.name()))));
  }

  private static boolean isHidden(Bundle other, Bundle from) {
    return isOneOf(COMPONENTS, other) || (from.matches("org.robotui.ruic.*") && isOneOf(HIDDEN_FROM_RUICS, other));
  }

  private static boolean isOneOf(List<String> patterns, Bundle bundle) {
    return patterns.stream().anyMatch(bundle::matches);
  }
}
