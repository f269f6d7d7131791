package org.robotui.architecture.tests;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * What an IDE imports and starts is all that there is: every bundle, feature and bundle of tests is a project; a launch
 * configuration of a product has the features of that product, there is one for each bundle of tests, and none names
 * what is not there.
 */
final class IdeRule implements Rule {

  private static final Pattern NAME = Pattern.compile("<name>([^<]+)</name>");

  private static final Pattern FEATURE = Pattern.compile("<feature\\s+id=\"([^\"]+)\"");

  private static final Pattern APPLICATION = Pattern.compile("<product [^>]*application=\"([^\"]+)\"");

  @Override
  public String statement() {
    return "everything is a project of the IDE, and its launch configurations name all that belongs to them and exists";
  }

  @Override
  public Stream<Violation> violations(Repository repository) {
    List<Launch> launches = Launch.allOf(repository);
    List<Path> tests = Trees.folders(repository.root().resolve("tests")).stream().filter(IdeRule::holdsTests).toList();
    List<Path> folders = Stream.of(
        Trees.folders(repository.root().resolve("bundles")).stream().filter(f -> Files.exists(f.resolve("META-INF"))),
        repository.features().stream().map(Path::getParent), tests.stream()).flatMap(all -> all).toList();
    return Stream
        .of(notImported(repository, folders), missing(repository, launches, folders), incomplete(repository, launches),
            withoutLaunch(tests, launches))
        .flatMap(all -> all);
  }

  private static boolean holdsTests(Path folder) {
    return folder.getFileName().toString().startsWith("org.robotui.") && Files.exists(folder.resolve("src"));
  }

  private static Stream<Violation> notImported(Repository repository, List<Path> folders) {
    return folders.stream().filter(folder -> !projectIn(folder).equals(Optional.of(folder.getFileName().toString())))
        .map(folder -> new Violation(repository.root().relativize(folder).toString(),
            "has no .project of its name, so that no IDE imports it"));
  }

  private static Stream<Violation> missing(Repository repository, List<Launch> launches, List<Path> folders) {
    Set<String> projects =
        Stream.concat(folders.stream(), Stream.of("product", "releng").map(repository.root()::resolve))
            .flatMap(folder -> projectIn(folder).stream()).collect(Collectors.toSet());
    return launches.stream().flatMap(launch -> Stream.concat(launch.projects(), launch.features().stream())
        .filter(name -> !projects.contains(name))
        .map(name -> new Violation(launch.path(), "names " + name + ", which is no project")));
  }

  private static Stream<Violation> incomplete(Repository repository, List<Launch> launches) {
    Map<String, Set<String>> products = new HashMap<>();
    for (Path product : Trees.files(repository.root().resolve("product"), ".product")) {
      String text = Trees.read(product);
      Set<String> features = FEATURE.matcher(text).results().map(found -> found.group(1)).collect(Collectors.toSet());
      APPLICATION.matcher(text).results().forEach(found -> products.put(found.group(1), features));
    }
    Stream<Violation> different = launches.stream().filter(Launch::isApplication)
        .filter(launch -> !launch.features().equals(products.getOrDefault(launch.application().orElse(""), Set.of())))
        .map(launch -> new Violation(launch.path(), "has other features than the product of its application"));
    Stream<Violation> none = products.keySet().stream()
        .filter(application -> launches.stream()
            .noneMatch(launch -> launch.isApplication() && launch.application().orElse("").equals(application)))
        .map(application -> new Violation("releng", "has no launch configuration of " + application));
    return Stream.concat(different, none);
  }

  private static Stream<Violation> withoutLaunch(List<Path> tests, List<Launch> launches) {
    return tests.stream().map(folder -> folder.getFileName().toString())
        .filter(name -> launches.stream().noneMatch(launch -> launch.project().filter(name::equals).isPresent()))
        .map(name -> new Violation("releng", "has no launch configuration of " + name));
  }

  private static Optional<String> projectIn(Path folder) {
    Path file = folder.resolve(".project");
    return Files.exists(file) ? NAME.matcher(Trees.read(file)).results().map(found -> found.group(1)).findFirst()
        : Optional.empty();
  }
}
