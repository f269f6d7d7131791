package org.robotui.message;

import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Stream;

/** All records of messages that this library ships, found where their classes are. */
public final class ShippedRecords {

  private ShippedRecords() {}

  /** The codecs of ROS 1 by the name of the type, services' requests and responses included. */
  static Map<String, RecordCodec<?>> codecs() throws IOException {
    Map<String, RecordCodec<?>> codecs = new TreeMap<>();
    for (Class<?> each : records()) {
      if (new ShippedDefinitions(Generation.ROS1).has(RecordCodec.typeOf(each))) {
        codecs.put(RecordCodec.typeOf(each), RecordCodec.of(each.asSubclass(Record.class)));
      }
    }
    return codecs;
  }

  private static List<Class<?>> records() throws IOException {
    List<Class<?>> records = new ArrayList<>();
    Path root = classes();
    try (Stream<Path> files = Files.walk(root.resolve("org/robotui/message/ros"))) {
      for (Path each : (Iterable<Path>) files.filter(f -> f.toString().endsWith(".class"))::iterator) {
        String name = root.relativize(each).toString().replace('/', '.').replaceFirst("\\.class$", "");
        Class<?> type = Class.forName(name);
        if (type.isRecord()) {
          records.add(type);
        }
      }
    } catch (ReflectiveOperationException e) {
      throw new IllegalStateException(e);
    }
    return records;
  }

  /** The record of a type, bound to its definition. */
  static RecordBinding<?> binding(String type, Generation generation) throws IOException {
    Class<?> found =
        records().stream().filter(each -> RecordCodec.typeOf(each).equals(type)).findFirst().orElseThrow();
    return RecordBinding.shipped(found.asSubclass(Record.class), generation);
  }

  /** Whether a record has all that ROS 2 sends. */
  static boolean isComplete(String type) {
    return !type.matches("std_msgs/Empty|sensor_msgs/Range|visualization_msgs/(Interactive)?Marker.*");
  }

  /** The codec of one type, empty if there is no record of it. */
  public static Optional<RecordCodec<?>> codec(String type) throws IOException {
    return Optional.ofNullable(codecs().get(type));
  }

  private static Path classes() {
    try {
      return Path.of(RecordCodec.class.getProtectionDomain().getCodeSource().getLocation().toURI());
    } catch (URISyntaxException e) {
      throw new IllegalStateException(e);
    }
  }
}
