package org.robotui.uic.sound.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.api.config.Placed;
import org.robotui.api.config.Schema;
import org.robotui.api.config.SettingFault;
import org.robotui.api.config.Settings;
import org.robotui.api.config.ValueType;

/** What is wrong with alerts is known when the configuration is read. */
class SoundFaultsTest {
  @TempDir
  Path folder;

  @Test
  void aSoundIsAFileOfItsKindBesideTheConfiguration() throws IOException {
    Files.writeString(folder.resolve("horn.wav"), "RIFF\0\0\0\0WAVEfmt ", StandardCharsets.ISO_8859_1);
    Files.writeString(folder.resolve("secret.wav"), "root:x:0:0:");
    Files.createDirectory(folder.resolve("folder.wav"));

    assertEquals(List.of(), faults("horn.wav"));
    assertEquals(List.of(), faults(folder.resolve("horn.wav").toString()));
    assertEquals(List.of("robot.yaml:4:9: 'sound' must be a WAV file: secret.wav is none"), faults("secret.wav"));
    assertEquals(List.of("robot.yaml:4:9: 'sound' must be a WAV file: folder.wav is a folder; name a file"),
        faults("folder.wav"));
    assertEquals(List.of("robot.yaml:4:9: 'sound' must be a WAV file: none.wav is not there"), faults("none.wav"));
  }

  @Test
  void aScriptIsAFileBesideTheConfiguration() throws IOException {
    Files.writeString(folder.resolve("home.js"), "print(alert.name)");
    assertEquals(List.of(), faults(Map.of(SoundType.SCRIPT, written("home.js"))));
    assertEquals(List.of("robot.yaml:4:9: 'script': the script none.js is not there"),
        faults(Map.of(SoundType.SCRIPT, written("none.js"))));
  }

  @Test
  void theSchemaKnowsConditionsTimesAndSounds() {
    assertEquals(Optional.empty(), fault(SoundType.ALERT, SoundType.WHEN, "battery charge < 0.2 for 5 s"));
    assertEquals(
        "'battery <<' cannot be read; write a source, a field, a comparison and a value, for example 'battery charge < 0.2', "
            + "'battery status changes', 'scan stale', 'link lost', 'diagnostics >= ERROR' or 'log >= ERROR'",
        fault(SoundType.ALERT, SoundType.WHEN, "battery <<").orElseThrow());
    assertEquals("there is no sound '../../../etc/passwd'; write one of beep, chime, alarm, or the path of a .wav file",
        fault(SoundType.ALERT, SoundType.SOUND, "../../../etc/passwd").orElseThrow());
    assertEquals(Optional.empty(), fault(SoundType.SCHEMA, SoundType.MUTED_UNTIL, "2026-11-21T18:00"));
    assertEquals("muted_until: '6 pm' is no time; write for example 2026-11-21T18:00, or with Z for UTC",
        fault(SoundType.SCHEMA, SoundType.MUTED_UNTIL, "6 pm").orElseThrow());
  }

  private static Optional<String> fault(Schema schema, String setting, String text) {
    ValueType type = schema.find(setting).orElseThrow().type();
    ValueType plain = type instanceof ValueType.WithPlace placed ? placed.value() : type;
    return ((ValueType.Text) plain).rule().fault().apply(text);
  }

  private List<String> faults(String sound) {
    return faults(Map.of(SoundType.SOUND, written(sound)));
  }

  private Placed written(String value) {
    return new Placed(value, folder.resolve("robot.yaml").toString(), 4, 9);
  }

  private List<String> faults(Map<String, Object> of) {
    Map<String, Object> values = new HashMap<>(of);
    values.put(SoundType.WHEN, "link lost");
    Settings alert = filled(SoundType.ALERT, values);
    return new SoundType().faults(filled(SoundType.SCHEMA, Map.of(SoundType.ALERTS, List.of(alert)))).stream()
        .map(SettingFault::toString).map(s -> s.replace(folder + "/", "")).toList();
  }

  private static Settings filled(Schema schema, Map<String, Object> values) {
    Map<String, Object> all = new HashMap<>(values);
    schema.settings().forEach(setting -> setting.fallback().ifPresent(value -> all.putIfAbsent(setting.name(), value)));
    return new Settings(schema, all);
  }
}
