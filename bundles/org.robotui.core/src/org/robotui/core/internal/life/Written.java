package org.robotui.core.internal.life;

import java.util.Map;
import org.robotui.api.host.InterfaceConfig;
import org.robotui.core.internal.config.Checksum;
import org.robotui.core.internal.config.model.ChosenInterface;
import org.robotui.core.internal.config.model.ComponentConfig;
import org.robotui.core.internal.config.model.RuicConfig;
import org.robotui.core.internal.config.model.SettingsCheck;

/**
 * Robot interfaces as they are written, shown and kept.
 *
 * @param check reads and makes written settings
 */
record Written(SettingsCheck check) {
  /** As applications see it. */
  InterfaceConfig show(ComponentConfig config) {
    return new InterfaceConfig(config.id(), config.type(), config.robot(), config.title(), check.values(config.raw()));
  }

  /** As if it stood in the place of another one. */
  ComponentConfig place(InterfaceConfig wanted, ComponentConfig at) {
    return new ComponentConfig(at.id(), wanted.type(), wanted.title(),
        wanted.robot().isBlank() ? at.robot() : wanted.robot(),
        check.written(wanted.settings()), at.file(), at.line(), at.column());
  }

  /** What is kept of it, in place of a written one. */
  ChosenInterface keep(ComponentConfig chosen, ComponentConfig insteadOf) {
    return new ChosenInterface(chosen.type(), chosen.robot(), check.values(chosen.raw()), mark(insteadOf));
  }

  /** Whether both say the same, wherever they stand. */
  boolean same(ComponentConfig one, ComponentConfig other) {
    return show(one).equals(show(other));
  }

  /** What the file says, changed by what the user has exchanged since; what the file says anew is newer. */
  RuicConfig withChosen(RuicConfig written, RuicOverlay overlay) {
    RuicConfig now = written;
    for (Map.Entry<String, ChosenInterface> entry : overlay.interfaces().entrySet()) {
      now = now.rfic(entry.getKey()).filter(c -> mark(c).equals(entry.getValue().insteadOf()))
          .map(c -> chosen(entry.getValue(), c)).map(now::with).orElse(now);
    }
    return now;
  }

  private ComponentConfig chosen(ChosenInterface chosen, ComponentConfig at) {
    return place(new InterfaceConfig(at.id(), chosen.type(), chosen.robot(), at.title(), chosen.settings()), at);
  }

  private String mark(ComponentConfig config) {
    return Checksum.of(show(config).toString());
  }
}
