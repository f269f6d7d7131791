package org.robotui.core.internal.compose;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.robotui.api.bridge.BridgeWords;
import org.robotui.api.config.Schema;
import org.robotui.api.config.WriteFailure;
import org.robotui.api.host.ConfigSettings;
import org.robotui.api.host.Problem;
import org.robotui.api.host.Problem.Severity;
import org.robotui.api.host.RuicSnapshot;
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
  private final Supplier<List<RuicSnapshot>> robots;

  /**
   * For the files of a host.
   *
   * @param configs reads configurations
   * @param registry the types
   * @param check reads values
   * @param files that run now
   * @param robots what is known of the robot UIs that run now
   */
  public WrittenSettings(ConfigSource configs, Registry registry, SettingsCheck check, Supplier<List<Path>> files,
      Supplier<List<RuicSnapshot>> robots) {
    this.configs = configs;
    this.registry = registry;
    this.check = check;
    this.files = files;
    this.robots = robots;
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
      case BRIDGES -> BridgeWords.SCHEMA;
      case CONNECTIONS -> Schema.of();
    };
  }

  private Stream<SettingsGroup> groups(Path file) {
    try {
      String text = new ConfigFile(file).read();
      Optional<WrittenText> written = configs.written(file, text);
      return written.stream().flatMap(w -> {
        PortChoices ports = new PortChoices(robots.get());
        RuicGroups groups = new RuicGroups(registry, check, w, file, Checksum.of(text), ports);
        return Stream.concat(configs.read(file, text, registry).ruics().stream().flatMap(groups::of),
            Stream.of(groups.bridges()));
      });
    } catch (IOException e) {
      LOG.info("{} cannot be read: {}", file, e.getMessage());
      return Stream.empty();
    }
  }

  @Override
  public synchronized SettingsOutcome write(SettingsGroup group, Map<String, Object> values) {
    ConfigFile file = new ConfigFile(group.file());
    List<String> changes = group.changed(values);
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
      String after = changed(before, group, values);
      Optional<Problem> error = error(group.file(), after);
      if (error.isPresent()) {
        return new SettingsOutcome.Refused(error.get().message());
      }
      file.replace(after);
      LOG.info("wrote {} of {} into {}", changes, String.join("/", group.path()), group.file());
      return new SettingsOutcome.Done(group.file(), changes);
    } catch (PathEdit.Refusal e) {
      return new SettingsOutcome.Refused(group.file() + ":" + e.line() + ": " + e.getMessage());
    } catch (IOException e) {
      return new SettingsOutcome.Refused(group.file() + " cannot be written: " + WriteFailure.reason(e));
    }
  }

  private static Optional<String> unlike(SettingsGroup group, String text) {
    return Checksum.of(text).equals(group.reading()) ? Optional.empty()
        : Optional.of(group.file() + " was changed meanwhile; look at what it says now");
  }

  private Optional<Problem> error(Path file, String text) {
    return configs.read(file, text, registry).problems().stream().filter(p -> p.severity() == Severity.ERROR)
        .findFirst();
  }

  private static String changed(String before, SettingsGroup group, Map<String, Object> values)
      throws PathEdit.Refusal {
    String text = before;
    for (String name : group.changed(values)) {
      List<String> path = new ArrayList<>(group.path());
      path.add(name);
      Optional<Object> value = Optional.ofNullable(values.get(name));
      text = value.isEmpty() ? PathEdit.remove(text, path)
          : new ValueEdit(path).set(text, group.values().getOrDefault(name, ""), value.get(),
              group.schema().find(name).orElseThrow().type());
    }
    return text;
  }
}
