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
 * The definitions of the packages installed on this machine, found as ROS lays them out: {@code PACKAGE/msg/Type.msg},
 * {@code PACKAGE/srv/Type.srv} and {@code PACKAGE/action/Type.action}, for ROS 2 also {@code .idl}. Folders are read at
 * each question, which may take a while: not for I/O threads.
 */
public final class LocalDefinitions implements Definitions {

  private static final Pattern TYPE = Pattern.compile("[A-Za-z]\\w*/[A-Za-z]\\w*");

  private static final int MAX_PACKAGES = 2000;

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

  /**
   * Looks where ROS 2 does: in folders that a setting names, then in the share folders of AMENT_PREFIX_PATH and
   * COLCON_PREFIX_PATH. A folder of a setting may be a package, hold packages up to four levels down, or be the root of
   * an installation.
   *
   * @param folders those of a setting, which win
   * @param environment the environment variables
   * @return the definitions found there at the time of each question
   */
  public static LocalDefinitions ofRos2(List<Path> folders, Map<String, String> environment) {
    List<Path> shares = new ArrayList<>();
    folders.forEach(folder -> shares.add(folder.resolve("share")));
    paths(environment, "AMENT_PREFIX_PATH").forEach(prefix -> shares.add(prefix.resolve("share")));
    paths(environment, "COLCON_PREFIX_PATH").forEach(prefix -> shares.addAll(isolated(prefix)));
    return new LocalDefinitions(shares, folders, Generation.ROS2);
  }

  /** An installation of colcon is one prefix, or has one for each package. */
  private static List<Path> isolated(Path prefix) {
    List<Path> shares = new ArrayList<>(List.of(prefix.resolve("share")));
    try (Stream<Path> children = Files.list(prefix)) {
      children.map(child -> child.resolve("share")).filter(Files::isDirectory).limit(MAX_PACKAGES).forEach(shares::add);
    } catch (IOException e) {
      // a folder that cannot be read holds nothing for us
      return shares;
    }
    return shares;
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

  @Override
  public Optional<ServiceDefinition> service(String type) throws DefinitionException {
    Optional<String> text = text(type, "srv");
    return text.isEmpty() ? Optional.empty() : Optional.of(ServiceDefinition.parse(type, text.get(), generation));
  }

  @Override
  public Optional<ActionDefinition> action(String type) throws DefinitionException {
    Optional<String> text = text(type, "action");
    return text.isEmpty() ? Optional.empty() : Optional.of(ActionDefinition.parse(type, text.get()));
  }

  private Optional<String> text(String type, String kind) throws DefinitionException {
    if (!TYPE.matcher(type).matches()) {
      return Optional.empty();
    }
    String packageName = type.substring(0, type.indexOf('/'));
    Path inside = Path.of(kind, type.substring(packageName.length() + 1) + "." + kind);
    Optional<Path> file = file(packageName, inside);
    if (file.isPresent()) {
      return Optional.of(read(type, file.get()));
    }
    return generation == Generation.ROS2 ? idl(type, kind) : Optional.empty();
  }

  /** Packages of ROS 2 may define their types in IDL alone. */
  private Optional<String> idl(String type, String kind) throws DefinitionException {
    String packageName = type.substring(0, type.indexOf('/'));
    String name = type.substring(packageName.length() + 1);
    Optional<Path> file = file(packageName, Path.of(kind, name + ".idl"));
    return file.isEmpty() ? Optional.empty() : Optional.of(IdlText.definition(type, kind, read(type, file.get())));
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
