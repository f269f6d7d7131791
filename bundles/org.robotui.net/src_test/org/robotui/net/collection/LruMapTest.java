package org.robotui.net.collection;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class LruMapTest {
  private final LruMap<String, Integer> map = new LruMap<>(3);

  @BeforeEach
  void fill() {
    map.put("a", 1);
    map.put("b", 2);
    map.put("c", 3);
  }

  private List<String> keys() {
    return List.copyOf(map.keySet());
  }

  @Test
  void theOldestGoes() {
    map.put("d", 4);
    assertEquals(List.of("b", "c", "d"), keys());
  }

  @Test
  void whatIsReadStays() {
    map.get("a");
    map.computeIfAbsent("d", key -> 4);
    assertEquals(List.of("c", "a", "d"), keys());
  }

  @Test
  void whatIsWrittenAgainStays() {
    map.put("a", 5);
    map.put("d", 4);
    assertEquals(List.of("c", "a", "d"), keys());
  }

  @Test
  void lookingAtAllOfThemChangesNoOrder() {
    map.forEach((key, value) -> {});
    map.put("d", 4);
    assertEquals(List.of("b", "c", "d"), keys());
  }

  @Test
  void aMapOfNothingIsRefused() {
    assertThrows(IllegalArgumentException.class, () -> new LruMap<>(0));
  }
}
