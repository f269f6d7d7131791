package org.robotui.architecture.tests;

import java.util.stream.Stream;

/** Internals are not exported, and nothing at all by bundles that bundles/LAYERS has for nobody. */
final class ExportRule implements Rule {

  @Override
  public String statement() {
    return "internals are not exported";
  }

  @Override
  public Stream<Violation> violations(Repository repository) {
    return repository.bundles().stream().flatMap(bundle -> bundle.manifest().exportedPackages().stream()
        .flatMap(exported -> complaints(bundle, exported, repository.layers())
            .map(complaint -> new Violation(bundle.name(), "exports " + exported + ": " + complaint))));
  }

  private static Stream<String> complaints(Bundle bundle, String exported, Layers layers) {
    if (layers.height(bundle.name()).stream().anyMatch(height -> layers.at(height).isForNobody())) {
      return Stream.of("this bundle exports nothing");
    }
    if ((exported + ".").contains(".internal.")) {
      return Stream.of("internal packages stay inside");
    }
    return bundle.sources().stream().noneMatch(source -> source.folderPackage().equals(exported))
        ? Stream.of("there is no such package")
        : Stream.empty();
  }
}
