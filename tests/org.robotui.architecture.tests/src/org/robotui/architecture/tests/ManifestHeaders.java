package org.robotui.architecture.tests;

import java.util.Arrays;
import java.util.List;
import java.util.jar.Manifest;

/** The headers of a bundle's manifest that the rules look at. */
record ManifestHeaders(Manifest manifest) {

  String symbolicName() {
    return names("Bundle-SymbolicName").stream().findFirst().orElse("");
  }

  List<String> importedPackages() {
    return names("Import-Package");
  }

  List<String> exportedPackages() {
    return names("Export-Package");
  }

  List<String> requiredBundles() {
    return names("Require-Bundle");
  }

  String header(String name) {
    String value = manifest.getMainAttributes().getValue(name);
    return value == null ? "" : value;
  }

  /** The names in a header, without attributes: commas inside quotes (version ranges) do not separate. */
  private List<String> names(String header) {
    String withoutQuoted = header(header).replaceAll("\"[^\"]*\"", "");
    return Arrays.stream(withoutQuoted.split(","))
        .map(clause -> clause.split(";")[0].strip())
        .filter(name -> !name.isEmpty())
        .toList();
  }
}
