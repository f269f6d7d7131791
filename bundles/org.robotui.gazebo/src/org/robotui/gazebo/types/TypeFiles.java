package org.robotui.gazebo.types;

import com.google.protobuf.DescriptorProtos.FileDescriptorProto;
import com.google.protobuf.DescriptorProtos.FileDescriptorSet;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** The definitions of a search path, read once, with all files of a package taken together. */
final class TypeFiles {
  private static final Logger LOG = LoggerFactory.getLogger(TypeFiles.class);
  private static final List<String> USUAL = List.of("/usr/share/gz", "/usr/include/gz", "/usr/include/ignition");
  private static final int DEEPEST = 6;
  private static final int MOST_FILES = 3000;
  private static final long LONGEST = 1 << 22;

  private final List<Path> path;
  private Optional<Map<String, FileDescriptorProto.Builder>> read = Optional.empty();

  private TypeFiles(List<Path> path) {
    this.path = path;
  }

  static TypeFiles of(Map<String, String> variables) {
    Stream<String> named = Stream.of("GZ_DESCRIPTOR_PATH", "IGN_DESCRIPTOR_PATH")
        .flatMap(name -> Stream.of(variables.getOrDefault(name, "").split(":")));
    return new TypeFiles(Stream.concat(named, USUAL.stream()).filter(each -> each.startsWith("/")).map(Path::of)
        .distinct().toList());
  }

  List<String> searched() {
    return path.stream().map(Path::toString).toList();
  }

  /** All types of a package as one file. */
  synchronized Optional<FileDescriptorProto> all(String prefix) {
    if (read.isEmpty()) {
      read = Optional.of(read());
    }
    return Optional.ofNullable(read.get().get(prefix)).map(FileDescriptorProto.Builder::build);
  }

  private Map<String, FileDescriptorProto.Builder> read() {
    Map<String, FileDescriptorProto.Builder> packages = new HashMap<>();
    Set<String> names = new HashSet<>();
    for (Path file : files()) {
      for (FileDescriptorProto each : read(file)) {
        add(packages, names, each);
      }
    }
    return packages;
  }

  /** What is defined twice is what is found first. */
  private static void add(Map<String, FileDescriptorProto.Builder> packages, Set<String> names,
      FileDescriptorProto file) {
    FileDescriptorProto.Builder all = packages.computeIfAbsent(file.getPackage(),
        name -> FileDescriptorProto.newBuilder().setSyntax("proto3").setPackage(name).setName(name + ".proto"));
    file.getMessageTypeList().stream().filter(each -> names.add(file.getPackage() + "." + each.getName()))
        .forEach(all::addMessageType);
    file.getEnumTypeList().stream().filter(each -> names.add(file.getPackage() + "." + each.getName()))
        .forEach(all::addEnumType);
  }

  private List<Path> files() {
    List<Path> files = new ArrayList<>();
    for (Path each : path) {
      try (Stream<Path> within = Files.walk(each, DEEPEST)) {
        within.filter(TypeFiles::isDefinition).sorted().limit(MOST_FILES).forEach(files::add);
      } catch (IOException | RuntimeException e) {
        LOG.debug("{} has no definitions of types: {}", each, e.toString());
      }
    }
    return files;
  }

  private static boolean isDefinition(Path file) {
    String name = file.getFileName().toString();
    return (name.endsWith(".proto") || isSet(name)) && Files.isRegularFile(file);
  }

  private static boolean isSet(String name) {
    return name.endsWith(".desc") || name.endsWith(".gz_desc");
  }

  private static List<FileDescriptorProto> read(Path file) {
    try {
      if (Files.size(file) > LONGEST) {
        throw new IOException("it has more than " + LONGEST + " bytes");
      }
      return isSet(file.getFileName().toString()) ? FileDescriptorSet.parseFrom(Files.readAllBytes(file)).getFileList()
          : List.of(ProtoReader.read(Files.readString(file)));
    } catch (IOException | RuntimeException e) {
      LOG.warn("the types of {} cannot be read: {}", file, e.getMessage());
      return List.of();
    }
  }
}
