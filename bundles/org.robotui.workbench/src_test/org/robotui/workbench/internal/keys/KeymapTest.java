package org.robotui.workbench.internal.keys;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.stream.Stream;
import org.eclipse.jface.bindings.keys.KeySequence;
import org.junit.jupiter.api.Test;

class KeymapTest {
  private final KeyedCommand stop = command("stop", true, "F12");
  private final KeyedCommand lease = command("lease", false, "Ctrl+L");
  private final KeyedCommand search = command("search", false, "Ctrl+3", "Ctrl+Shift+P");
  private final KeyedCommand reload = command("reload", false);
  private final Keymap usual = new Keymap(List.of(stop, lease, search, reload), Map.of());

  @Test
  void aKeyThatIsGivenToOneCommandIsTakenFromTheOther() {
    assertEquals(List.of(lease), usual.holders(key("Ctrl+L"), reload));

    Keymap next = usual.taking(reload, keys("Ctrl+L"));

    assertEquals(List.of(), next.keys(lease));
    assertEquals(keys("Ctrl+L"), next.keys(reload));
    assertEquals(reload, next.bound().get(key("Ctrl+L")));
    assertEquals(List.of(), next.conflicts());
    assertEquals(usual, next.reset(reload).reset(lease));
    assertEquals(usual, next.usual());
  }

  @Test
  void ofTwoCommandsWithTheSameKeyTheChangedOneRuns() {
    Keymap clash = usual.with(reload, keys("Ctrl+L"));

    assertEquals(reload, clash.bound().get(key("Ctrl+L")));
    assertEquals(List.of(lease), clash.conflicts());
    assertTrue(clash.isChanged(reload) && !clash.isChanged(lease));
  }

  @Test
  void aKeyThatBeginsAsAnotherDoesClashesWithIt() {
    Keymap next = usual.taking(reload, keys("Ctrl+3 Ctrl+R"));

    assertEquals(keys("Ctrl+Shift+P"), next.keys(search));
    assertEquals(List.of(search), usual.holders(key("Ctrl+3 Ctrl+R"), reload));
  }

  @Test
  void whatIsSetToTheUsualKeysIsNoChange() {
    assertFalse(usual.with(lease, keys("Ctrl+K")).with(lease, keys("Ctrl+L")).isChanged(lease));
  }

  @Test
  void theKeyThatStopsRobotsStaysWhateverIsKept() {
    Keymap damaged = new Keymap(usual.commands(), Map.of("stop", List.of(), "reload", keys("F12")));

    assertEquals(stop, damaged.bound().get(KeyRules.STOP));
    assertEquals(List.of(reload), damaged.conflicts());
    assertTrue(KeyRules.fixed(stop).orElseThrow().contains("keeps F12"));
    assertTrue(KeyRules.refusal(KeyRules.STOP).orElseThrow().contains("stops all robots"));
  }

  @Test
  void keysThatTypeOrThatViewsTakeAreRefused() {
    Stream.of("A", "Shift+A", "Space", "Esc", "Tab", "Shift+Page_Down", "/", "Ctrl+C", "Ctrl+K Z")
        .forEach(text -> assertTrue(KeyRules.refusal(key(text)).isPresent(), text));
    Stream.of("F5", "Shift+F12", "Alt+1", "Ctrl+Space", "Ctrl+K Ctrl+Z")
        .forEach(text -> assertEquals(Optional.empty(), KeyRules.refusal(key(text)), text));
  }

  @Test
  void keysAreWrittenAsTheyAreRead() {
    for (String text : List.of("Ctrl+Shift+P", "F11", "Alt+Arrow_Up", "Ctrl+K Ctrl+S")) {
      assertEquals(text, KeyWords.text(key(text)));
    }
    assertEquals(key("Ctrl+Shift+P"), key("ctrl+shift+p"));
    assertTrue(KeyWords.read("").isEmpty() && KeyWords.read("Ctrl+").isEmpty() && KeyWords.read("Hyper+Q").isEmpty());
  }

  @Test
  void whateverIsChangedEveryKeyRunsOneCommandAndTheStopStays() {
    Random random = new Random(7);
    List<KeySequence> some = keys("Ctrl+L", "Ctrl+3", "F5", "F12", "Ctrl+K Ctrl+S", "Ctrl+K", "Alt+1");
    Keymap map = usual;
    for (int step = 0; step < 3000; step++) {
      KeyedCommand command = map.commands().get(random.nextInt(4));
      List<KeySequence> keys = List.of(some.get(random.nextInt(some.size())));
      map = switch (random.nextInt(4)) {
        case 0 -> map.with(command, keys);
        case 1 -> map.reset(command);
        default -> map.taking(command, keys);
      };
      Keymap now = map;
      assertEquals(stop, now.bound().get(KeyRules.STOP));
      now.bound().forEach((key, runs) -> assertTrue(now.keys(runs).contains(key)));
      assertTrue(now.conflicts().stream()
          .allMatch(c -> now.keys(c).stream().anyMatch(k -> !now.holders(k, c).isEmpty() || now.keys(c).size() > 1)));
    }
  }

  static KeyedCommand command(String id, boolean fixed, String... usual) {
    return new KeyedCommand(id, "Command " + id, "Robot", "", keys(usual), fixed);
  }

  static List<KeySequence> keys(String... texts) {
    return Stream.of(texts).map(KeymapTest::key).toList();
  }

  static KeySequence key(String text) {
    return KeyWords.read(text).orElseThrow(() -> new AssertionError(text));
  }
}
