package org.robotui.core.internal.compose;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.WriteFailure;
import org.robotui.api.host.ConfigSettings;
import org.robotui.api.host.Problem;
import org.robotui.api.host.Problem.Severity;
import org.robotui.api.host.SettingsGroup;
import org.robotui.api.host.SettingsOutcome;
import org.robotui.core.internal.config.Checksum;
import org.robotui.core.internal.config.model.ConfigSource;
import org.robotui.core.internal.config.model.FixedWords;
import org.robotui.core.internal.config.model.SettingsCheck;
import org.robotui.core.internal.config.model.WrittenText;
import org.robotui.core.internal.life.Registry;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** The settings that stand in configuration files, and changes of them there. */
public final class WrittenSettings implements ConfigSettings {
  private static final Logger LOG = LoggerFactory.getLogger(WrittenSettings.class);

  private final ConfigSource configs;
  private final Registry registry;
  private final SettingsCheck check;
  private final Supplier<List<Path>> files;

  /**
   * For the files of a host.
   *
   * @param configs reads configurations
   * @param registry the types
   * @param check reads values
   * @param files that run now
   */
  public WrittenSettings(ConfigSource configs, Registry registry, SettingsCheck check, Supplier<List<Path>> files) {
    this.configs = configs;
    this.registry = registry;
    this.check = check;
    this.files = files;
  }

  @Override
  public List<SettingsGroup> groups() {
    return files.get().stream().flatMap(this::groups).toList();
  }

  @Override
  public Schema always(SettingsGroup.Part part) {
    return switch (part) {
      case RUIC -> FixedWords.RUIC;
      case INTERFACE -> FixedWords.INTERFACE;
      case VIEW -> FixedWords.VIEW;
      case SAFETY -> FixedWords.SAFETY;
      case CONNECTIONS -> Schema.of();
    };
  }

  private Stream<SettingsGroup> groups(Path file) {
    try {
      String text = new ConfigFile(file).read();
      Optional<WrittenText> written = configs.written(file, text);
      return written.stream().flatMap(w -> {
        RuicGroups groups = new RuicGroups(registry, check, w, file, Checksum.of(text));
        return configs.read(file, text, registry).ruics().stream().flatMap(groups::of);
      });
    } catch (IOException e) {
      LOG.info("{} cannot be read: {}", file, e.getMessage());
      return Stream.empty();
    }
  }

  @Override
  public synchronized SettingsOutcome write(SettingsGroup group, Map<String, Object> values) {
    ConfigFile file = new ConfigFile(group.file());
    Map<String, Optional<Object>> changes = changes(group, values);
    if (changes.isEmpty()) {
      return new SettingsOutcome.Done(group.file(), List.of());
    }
    try {
      String before = file.read();
      Optional<String> refusal = file.obstacle().or(() -> unlike(group, before))
          .or(() -> error(group.file(), before).map(p -> "the file has an error, which comes first: " + p));
      if (refusal.isPresent()) {
        return new SettingsOutcome.Refused(refusal.get());
      }
      String after = changed(before, group, changes);
      Optional<Problem> error = error(group.file(), after);
      if (error.isPresent()) {
        return new SettingsOutcome.Refused(error.get().message());
      }
      file.replace(after);
      LOG.info("wrote {} of {} into {}", changes.keySet(), String.join("/", group.path()), group.file());
      return new SettingsOutcome.Done(group.file(), List.copyOf(changes.keySet()));
    } catch (PathEdit.Refusal e) {
      return new SettingsOutcome.Refused(group.file() + ":" + e.line() + ": " + e.getMessage());
    } catch (IOException e) {
      return new SettingsOutcome.Refused(group.file() + " cannot be written: " + WriteFailure.reason(e));
    }
  }

  private static Map<String, Optional<Object>> changes(SettingsGroup group, Map<String, Object> values) {
    Map<String, Optional<Object>> changes = new LinkedHashMap<>();
    for (Setting setting : group.schema().settings()) {
      String name = setting.name();
      if (!Objects.equals(group.values().get(name), values.get(name))) {
        changes.put(name, Optional.ofNullable(values.get(name)));
      }
    }
    return changes;
  }

  private static Optional<String> unlike(SettingsGroup group, String text) {
    return Checksum.of(text).equals(group.reading()) ? Optional.empty()
        : Optional.of(group.file() + " was changed meanwhile; look at what it says now");
  }

  private Optional<Problem> error(Path file, String text) {
    return configs.read(file, text, registry).problems().stream().filter(p -> p.severity() == Severity.ERROR)
        .findFirst();
  }

  private static String changed(String before, SettingsGroup group, Map<String, Optional<Object>> changes)
      throws PathEdit.Refusal {
    String text = before;
    for (Map.Entry<String, Optional<Object>> change : changes.entrySet()) {
      List<String> path = new ArrayList<>(group.path());
      path.add(change.getKey());
      Optional<Object> value = change.getValue();
      text = value.isEmpty() ? PathEdit.remove(text, path)
          : PathEdit.set(text, path, value.get(), group.schema().find(change.getKey()).orElseThrow().type());
    }
    return text;
  }
}
