package org.robotui.message;

import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Stream;

/** All records of messages that this library ships, found where their classes are. */
public final class ShippedRecords {

  private ShippedRecords() {}

  /** The codecs by the name of the ROS type, services' requests and responses included. */
  static Map<String, RecordCodec<?>> codecs() throws IOException {
    Map<String, RecordCodec<?>> codecs = new TreeMap<>();
    Path root = classes();
    try (Stream<Path> files = Files.walk(root.resolve("org/robotui/message/ros"))) {
      for (Path each : (Iterable<Path>) files.filter(f -> f.toString().endsWith(".class"))::iterator) {
        String name = root.relativize(each).toString().replace('/', '.').replaceFirst("\\.class$", "");
        Class<?> type = Class.forName(name);
        if (type.isRecord()) {
          RecordCodec<?> codec = RecordCodec.of(type.asSubclass(Record.class));
          codecs.put(codec.info().type(), codec);
        }
      }
    } catch (ReflectiveOperationException e) {
      throw new IllegalStateException(e);
    }
    return codecs;
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
