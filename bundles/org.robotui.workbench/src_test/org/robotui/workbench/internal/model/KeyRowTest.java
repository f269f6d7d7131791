package org.robotui.workbench.internal.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import org.eclipse.jface.bindings.keys.KeySequence;
import org.junit.jupiter.api.Test;
import org.robotui.ui.Health;
import org.robotui.ui.ViewKey;
import org.robotui.workbench.internal.keys.KeyWords;
import org.robotui.workbench.internal.keys.KeyedCommand;
import org.robotui.workbench.internal.keys.Keymap;

class KeyRowTest {
  private final KeyedCommand lease =
      new KeyedCommand("lease", "Take Control", "Robot", "", List.of(key("Ctrl+L")), false);
  private final KeyedCommand reload = new KeyedCommand("reload", "Read Again", "Robot", "", List.of(), false);
  private final Keymap usual = new Keymap(List.of(lease, reload), Map.of());

  @Test
  void aKeyOfTwoCommandsIsAConflictOfThatWhichDoesNotRun() {
    List<KeyRow> rows = KeyRow.of(usual.with(reload, List.of(key("Ctrl+L"))), Map.of(), "");

    assertEquals(Health.BAD, rows.getFirst().health());
    assertEquals("Ctrl+L runs 'Read Again'", rows.getFirst().note());
    assertEquals(Health.NONE, rows.getLast().health());
    assertEquals("changed", rows.getLast().note());
  }

  @Test
  void aKeyThatAViewLosesIsSaid() {
    Map<String, List<ViewKey>> views = Map.of("Log", List.of(new ViewKey("Ctrl+F, /", "Find")));

    KeyRow row = KeyRow.of(usual.with(lease, List.of(key("Ctrl+F"))), views, "control").getFirst();

    assertEquals(Health.WARNING, row.health());
    assertEquals("takes Ctrl+F from the view Log (Find); changed, usually Ctrl+L", row.note());
    assertTrue(row.refusal(key("F12")).isPresent() && row.refusal(key("F5")).isEmpty());
    assertEquals(List.of(), KeyRow.of(usual, views, "control nowhere"));
  }

  private static KeySequence key(String text) {
    return KeyWords.read(text).orElseThrow();
  }
}
