package org.robotui.architecture.tests;

import java.util.List;
import java.util.stream.Stream;

/** Who may use SWT and the Eclipse workbench. Who may use a bundle of ours says bundles/LAYERS. */
final class ReservedPackagesRule implements Rule {

  /** Packages with this prefix are reserved for the bundles that match one of the patterns. */
  private record Reservation(List<String> prefixes, List<String> users) {

    boolean covers(String name) {
      return prefixes.stream().anyMatch(prefix -> name.equals(prefix) || name.startsWith(prefix + "."));
    }

    boolean allows(Bundle bundle) {
      return users.stream().anyMatch(bundle::matches);
    }
  }

  private static final List<Reservation> RESERVATIONS = List.of(
      new Reservation(List.of("org.eclipse.swt", "org.eclipse.jface"),
          List.of("org.robotui.ui", "org.robotui.gl", "org.robotui.entity.*", "org.robotui.uic.*",
              "org.robotui.workbench",
              "org.robotui.testkit", "org.robotui.testkit.*")),
      new Reservation(List.of("org.eclipse.ui", "org.eclipse.e4"), List.of("org.robotui.workbench")));

  @Override
  public String statement() {
    return "no SWT below the ui, no Eclipse workbench below ours";
  }

  @Override
  public Stream<Violation> violations(Repository repository) {
    return repository.bundles().stream().flatMap(bundle -> RESERVATIONS.stream()
        .filter(reservation -> !reservation.allows(bundle))
        .flatMap(reservation -> Uses.of(bundle)
            .filter(use -> reservation.covers(use.name()))
            .map(use -> new Violation(use.where(),
                "uses " + use.name() + ", which only " + reservation.users() + " may"))));
  }
}
