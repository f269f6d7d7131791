package org.robotui.message;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * The definitions of the packages installed on this machine, found as ROS lays them out: {@code PACKAGE/msg/Type.msg}
 * and {@code PACKAGE/srv/Type.srv}. Folders are read at each question, which may take a while: not for I/O threads.
 */
public final class LocalDefinitions implements DefinitionSource {

  private static final Pattern TYPE = Pattern.compile("[A-Za-z]\\w*/[A-Za-z]\\w*");

  private final List<Path> shares;
  private final List<Path> trees;
  private final Generation generation;

  /**
   * Looks into folders.
   *
   * @param shares folders whose direct children are packages
   * @param trees folders that are packages or hold them up to four levels down
   */
  public LocalDefinitions(List<Path> shares, List<Path> trees) {
    this(shares, trees, Generation.ROS1);
  }

  /**
   * Looks into folders.
   *
   * @param shares folders whose direct children are packages
   * @param trees folders that are packages or hold them up to four levels down
   * @param generation whose definitions they hold
   */
  public LocalDefinitions(List<Path> shares, List<Path> trees, Generation generation) {
    this.generation = generation;
    this.shares = List.copyOf(shares);
    this.trees = List.copyOf(trees);
  }

  /**
   * Looks where ROS does: in ROS_PACKAGE_PATH, in the share folders of CMAKE_PREFIX_PATH, and in /usr/share, where
   * Debian installs.
   *
   * @param environment the environment variables
   * @return the definitions found there at the time of each question
   */
  public static LocalDefinitions fromEnvironment(Map<String, String> environment) {
    List<Path> shares = new ArrayList<>();
    paths(environment, "CMAKE_PREFIX_PATH").forEach(prefix -> shares.add(prefix.resolve("share")));
    shares.add(Path.of("/usr/share"));
    return new LocalDefinitions(shares, paths(environment, "ROS_PACKAGE_PATH"));
  }

  private static List<Path> paths(Map<String, String> environment, String name) {
    String value = environment.getOrDefault(name, "");
    return Arrays.stream(value.split(File.pathSeparator)).filter(s -> !s.isBlank()).map(Path::of).toList();
  }

  @Override
  public Optional<MessageDefinition> find(String type) throws DefinitionException {
    Optional<String> text = text(type, "msg");
    return text.isPresent()
        ? Optional.of(DefinitionParser.parse(type, text.get(), generation))
        : ServiceDefinition.messageOf(type, this::service);
  }

  /**
   * Finds a service.
   *
   * @param type the full name
   * @return empty if no folder has it
   * @throws DefinitionException if it is there and broken
   */
  public Optional<ServiceDefinition> service(String type) throws DefinitionException {
    Optional<String> text = text(type, "srv");
    return text.isEmpty() ? Optional.empty() : Optional.of(ServiceDefinition.parse(type, text.get(), generation));
  }

  private Optional<String> text(String type, String kind) throws DefinitionException {
    if (!TYPE.matcher(type).matches()) {
      return Optional.empty();
    }
    String packageName = type.substring(0, type.indexOf('/'));
    Path inside = Path.of(kind, type.substring(packageName.length() + 1) + "." + kind);
    Optional<Path> file = file(packageName, inside);
    return file.isEmpty() ? Optional.empty() : Optional.of(read(type, file.get()));
  }

  private Optional<Path> file(String packageName, Path inside) {
    Stream<Path> inTrees = trees.stream().flatMap(tree -> PackageSearch.find(tree, packageName, inside).stream());
    Stream<Path> inShares = shares.stream().map(share -> share.resolve(packageName).resolve(inside));
    return Stream.concat(inTrees, inShares).filter(Files::isRegularFile).findFirst();
  }

  private static String read(String type, Path file) throws DefinitionException {
    try {
      if (Files.size(file) > DefinitionParser.MAX_TEXT) {
        throw new DefinitionException(type, file + " is too long");
      }
      return new String(Files.readAllBytes(file), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new DefinitionException(type, file + " cannot be read: " + e.getMessage());
    }
  }
}
