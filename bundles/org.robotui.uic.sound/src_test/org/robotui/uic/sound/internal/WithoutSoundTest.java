package org.robotui.uic.sound.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.io.InputStream;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.robotui.api.Uic;
import org.robotui.api.UicType;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Settings;
import org.robotui.api.host.RuicSnapshot;
import org.robotui.api.host.RuicState;
import org.robotui.api.link.LinkState;
import org.robotui.testkit.FakeUicContext;

/** A Java without java.desktop, as small images have it. */
class WithoutSoundTest {
  private final List<Runnable> background = new ArrayList<>();

  @Test
  void alertsWorkWhereJavaHasNoSound() throws Exception {
    UicType type = (UicType) new Soundless().loadClass(SoundType.class.getName()).getConstructor().newInstance();
    FakeUicContext context = new FakeUicContext("sound", type.schema());
    context.background(background::add);
    try (Uic uic = type.create(context, settings(type.schema()))) {
      uic.tick(0);
      context.ruic().snapshot(new RuicSnapshot("Keira", RuicState.SELECTED, "",
          new LinkState.Failed("refused", Duration.ofSeconds(1)), List.of(), List.of(), List.of()));
      uic.tick(1);
      assertEquals(1, background.size(), "the alert is played in the background");
      background.getFirst().run();
    }
  }

  @Test
  void theLoaderOfThisTestHasNoSoundIndeed() {
    assertThrows(ClassNotFoundException.class, () -> new Soundless().loadClass("javax.sound.sampled.AudioSystem"));
  }

  private static Settings settings(Schema schema) {
    Settings alert = filled(SoundType.ALERT, Map.of("when", "link lost"));
    return filled(schema, Map.of("alerts", List.of(alert)));
  }

  private static Settings filled(Schema schema, Map<String, Object> values) {
    Map<String, Object> all = new HashMap<>(values);
    schema.settings().forEach(setting -> setting.fallback().ifPresent(value -> all.putIfAbsent(setting.name(), value)));
    return new Settings(schema, all);
  }

  /** Loads the bundle's classes anew, and nothing of javax.sound. */
  private static final class Soundless extends ClassLoader {
    private static final String OURS = SoundType.class.getPackageName();

    Soundless() {
      super(SoundType.class.getClassLoader());
    }

    @Override
    protected Class<?> loadClass(String name, boolean resolve) throws ClassNotFoundException {
      if (name.startsWith("javax.sound.")) {
        throw new ClassNotFoundException(name);
      }
      synchronized (getClassLoadingLock(name)) {
        return name.startsWith(OURS) && findLoadedClass(name) == null ? define(name) : super.loadClass(name, resolve);
      }
    }

    private Class<?> define(String name) throws ClassNotFoundException {
      try (InputStream stream = getParent().getResourceAsStream(name.replace('.', '/') + ".class")) {
        byte[] bytes = stream.readAllBytes();
        return defineClass(name, bytes, 0, bytes.length);
      } catch (IOException e) {
        throw new ClassNotFoundException(name, e);
      }
    }
  }
}
