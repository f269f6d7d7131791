package org.robotui.architecture.tests;

import java.util.List;
import java.util.stream.Stream;

/** Internals are not exported. */
final class ExportRule implements Rule {

  private static final List<String> EXPORTERS = List.of("org.robotui.geometry", "org.robotui.guard", "org.robotui.lcm", "org.robotui.player", "org.robotui.ros",
      "org.robotui.urdf", "org.robotui.xbot", "org.robotui.data", "org.robotui.api", "org.robotui.ui", "org.robotui.gl",
      "org.robotui.entity.*", "org.robotui.testkit", "org.robotui.testkit.*");

  @Override
  public String statement() {
    return "internals are not exported";
  }

  @Override
  public Stream<Violation> violations(Repository repository) {
    return repository.bundles().stream().flatMap(bundle -> bundle.manifest().exportedPackages().stream()
        .flatMap(exported -> complaints(bundle, exported)
            .map(complaint -> new Violation(bundle.name(), "exports " + exported + ": " + complaint))));
  }

  private static Stream<String> complaints(Bundle bundle, String exported) {
    if (EXPORTERS.stream().noneMatch(bundle::matches)) {
      return Stream.of("this bundle exports nothing");
    }
    if ((exported + ".").contains(".internal.")) {
      return Stream.of("internal packages stay inside");
    }
    return bundle.sources().stream().noneMatch(source -> source.folderPackage().equals(exported))
        ? Stream.of("there is no such package") : Stream.empty();
  }
}
