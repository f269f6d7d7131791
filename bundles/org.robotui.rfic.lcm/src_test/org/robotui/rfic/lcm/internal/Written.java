package org.robotui.rfic.lcm.internal;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.robotui.api.config.Placed;
import org.robotui.api.config.Settings;

/** Settings as core reads them: each mapping stands in a line of its own, each of its fields in a column of its own. */
public final class Written {
  private static final String FILE = "robot.yaml";

  private Written() {}

  /** The folder of types that we deliver. */
  public static Path types() {
    Stream<Path> places = Stream.concat(Optional.ofNullable(System.getenv("ROBOTUI_ROOT")).stream().map(Path::of),
        Stream.of(Path.of(""), Path.of("../..")));
    return places.map(p -> p.toAbsolutePath().resolve("configs/lcm/types")).filter(Files::isDirectory).findFirst()
        .orElseThrow(() -> new AssertionError("configs/lcm/types is not found: set ROBOTUI_ROOT to the repository"));
  }

  /** Settings of texts. */
  public static Settings settings(String url, Object types, Map<String, ?> channels, Map<String, ?> commands) {
    Map<String, Object> values = new HashMap<>();
    values.put("url", new Placed(url, FILE, 2, 7));
    values.put("types", new Placed(types, FILE, 3, 9));
    values.put("channels", all(channels, 10));
    values.put("commands", all(commands, 100));
    return new Settings(LcmSettings.SCHEMA, values);
  }

  /** The same settings, with a guard or not. */
  public static Settings guarded(Settings settings, boolean guard) {
    Map<String, Object> values = new HashMap<>(settings.values());
    values.put("guard", new Placed(guard, FILE, 4, 9));
    return new Settings(LcmSettings.SCHEMA, values);
  }

  private static Map<String, Object> all(Map<String, ?> mappings, int line) {
    Map<String, Object> all = new LinkedHashMap<>();
    mappings.forEach((channel, written) -> all.put(channel, written instanceof List<?> list
        ? list.stream().map(each -> mapping(each, line)).toList()
        : mapping(written, line)));
    return all;
  }

  private static Placed mapping(Object written, int line) {
    return new Placed(written instanceof Map<?, ?> map ? fields(map, line) : written, FILE, line, 5);
  }

  private static Map<String, Object> fields(Map<?, ?> map, int line) {
    Map<String, Object> fields = new LinkedHashMap<>();
    int column = 10;
    for (Map.Entry<?, ?> field : map.entrySet()) {
      fields.put(field.getKey().toString(), new Placed(field.getValue(), FILE, line, column++));
    }
    return fields;
  }

  /** Fields in their order. */
  public static Map<String, Object> map(Object... namesAndValues) {
    Map<String, Object> map = new LinkedHashMap<>();
    for (int i = 0; i < namesAndValues.length; i += 2) {
      map.put(namesAndValues[i].toString(), namesAndValues[i + 1]);
    }
    return map;
  }

  /** Settings that are right. */
  public static LcmSettings right(Settings settings) {
    SettingsReader reader = new SettingsReader(Map.of());
    LcmSettings read = reader.read(settings);
    assertTrue(reader.faults().isEmpty(), reader.faults().toString());
    return read;
  }
}
