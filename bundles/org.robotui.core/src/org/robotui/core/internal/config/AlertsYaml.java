package org.robotui.core.internal.config;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.DateTimeException;
import java.time.Instant;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.alert.AlertEvent;
import org.robotui.api.alert.AlertId;
import org.robotui.api.config.AtomicFile;
import org.robotui.api.config.NamedFile;
import org.robotui.core.internal.config.model.KeptAlerts;
import org.yaml.snakeyaml.error.YAMLException;

/** Keeps alerts as YAML. */
public final class AlertsYaml {
  private static final long MAX_BYTES = 4 << 20;
  private static final String UNTIL = "until";
  private static final String VIEW = "view";
  private static final String NAME = "name";

  private AlertsYaml() {}

  /**
   * Reads.
   *
   * @throws IOException where there is a file that cannot be read or understood
   */
  public static KeptAlerts read(Path file) throws IOException {
    if (!Files.exists(file)) {
      return KeptAlerts.NONE;
    }
    try {
      return kept(KeptYaml.map(KeptYaml.value(NamedFile.text(file, MAX_BYTES))));
    } catch (YAMLException | IllegalArgumentException | DateTimeException e) {
      throw new IOException(file + " is not what was kept there: " + e.getMessage(), e);
    }
  }

  /** Writes, for this user alone. */
  public static void write(Path file, KeptAlerts alerts) throws IOException {
    Map<String, Object> root = new LinkedHashMap<>();
    alerts.allMuted().ifPresent(until -> root.put("all_muted", until.toString()));
    root.put("muted", alerts.muted().entrySet().stream()
        .map(e -> Map.of(VIEW, e.getKey().view(), NAME, e.getKey().name(), UNTIL, e.getValue().toString())).toList());
    root.put("history", alerts.history().stream().map(AlertsYaml::written).toList());
    AtomicFile.writePrivate(file, KeptYaml.text(root));
  }

  private static Map<String, Object> written(AlertEvent event) {
    Map<String, Object> written = new LinkedHashMap<>();
    written.put("time", event.time().toString());
    written.put("what", event.kind().name());
    written.put(VIEW, event.id().view());
    written.put(NAME, event.id().name());
    written.put("source", event.source());
    written.put("value", event.value());
    written.put("by", event.by());
    return written;
  }

  private static KeptAlerts kept(Map<String, Object> root) {
    Map<AlertId, Instant> muted = new LinkedHashMap<>();
    for (Object item : KeptYaml.list(root.get("muted"))) {
      Map<String, Object> values = KeptYaml.map(item);
      muted.put(id(values), Instant.parse(text(values, UNTIL)));
    }
    List<AlertEvent> history = new ArrayList<>();
    for (Object item : KeptYaml.list(root.get("history"))) {
      Map<String, Object> values = KeptYaml.map(item);
      history.add(new AlertEvent(Instant.parse(text(values, "time")), id(values),
          AlertEvent.Kind.valueOf(text(values, "what")), text(values, "source"), text(values, "value"),
          text(values, "by")));
    }
    Optional<Instant> all = Optional.of(text(root, "all_muted")).filter(t -> !t.isEmpty()).map(Instant::parse);
    return new KeptAlerts(muted, all, history);
  }

  private static AlertId id(Map<String, Object> values) {
    return new AlertId(text(values, VIEW), text(values, NAME));
  }

  private static String text(Map<String, Object> values, String key) {
    return values.getOrDefault(key, "").toString();
  }
}
