package org.robotui.architecture.tests;

import java.util.stream.Stream;

/** What a bundle uses: the names in its manifest's imports and requirements, and in its sources (not its tests). */
final class Uses {

  /** A used package, bundle or type, and where it is named. */
  record Use(String where, String name) {}

  private Uses() {}

  static Stream<Use> of(Bundle bundle) {
    return Stream.concat(inManifest(bundle), inSources(bundle));
  }

  private static Stream<Use> inManifest(Bundle bundle) {
    String where = bundle.name() + "/META-INF/MANIFEST.MF";
    return Stream.concat(bundle.manifest().importedPackages().stream(), bundle.manifest().requiredBundles().stream())
        .map(name -> new Use(where, name));
  }

  private static Stream<Use> inSources(Bundle bundle) {
    return bundle.sources().stream()
        .flatMap(source -> source.qualifiedNames().stream().map(name -> new Use(source.where(), name)));
  }
}
