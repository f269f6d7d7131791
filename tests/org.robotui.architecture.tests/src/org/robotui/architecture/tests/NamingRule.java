package org.robotui.architecture.tests;

import java.util.stream.Stream;

/** A bundle's folder, its symbolic name and the root package of its sources are one and the same. */
final class NamingRule implements Rule {

  @Override
  public String statement() {
    return "bundle name = folder = root package, and what is not exported lies in an internal package";
  }

  @Override
  public Stream<Violation> violations(Repository repository) {
    return repository.bundles().stream().flatMap(bundle -> Stream.concat(wrongName(bundle), wrongPackages(bundle)));
  }

  private static Stream<Violation> wrongName(Bundle bundle) {
    String name = bundle.manifest().symbolicName();
    return name.equals(bundle.name()) ? Stream.empty()
        : Stream.of(new Violation(bundle.name(), "its Bundle-SymbolicName is " + name));
  }

  private static Stream<Violation> wrongPackages(Bundle bundle) {
    return Stream.concat(
        bundle.allSources().stream().filter(source -> !isUnder(bundle, source))
            .map(source -> new Violation(source.where(), "lies outside the package " + bundle.name())),
        bundle.sources().stream().filter(source -> isUnder(bundle, source)).map(SourceFile::folderPackage).distinct()
            .filter(name -> !isExportedOrInternal(bundle, name))
            .map(name -> new Violation(bundle.name(), "the package " + name + " is neither exported nor internal")));
  }

  private static boolean isUnder(Bundle bundle, SourceFile source) {
    return (source.folderPackage() + ".").startsWith(bundle.name() + ".")
        && source.parsed().packageName().equals(source.folderPackage());
  }

  /** The package of a program's main class is neither: the virtual machine is its only user. */
  private static boolean isExportedOrInternal(Bundle bundle, String packageName) {
    return (packageName + ".").contains(".internal.")
        || bundle.manifest().exportedPackages().contains(packageName)
        || bundle.sources().stream().anyMatch(source -> source.folderPackage().equals(packageName)
            && source.text().contains("public static void main("));
  }
}
