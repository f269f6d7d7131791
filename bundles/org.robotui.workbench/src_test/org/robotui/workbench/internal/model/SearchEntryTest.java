package org.robotui.workbench.internal.model;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;

class SearchEntryTest {
  private final List<SearchEntry> all =
      List.of(entry("Map", "Follow the robot"), entry("View", "Log"), entry("Robot", "Show Natalie"),
          entry("Robot", "Stop All Robots"), entry("View", "Robots"));

  @Test
  void whatBeginsWithTheWordsComesFirst() {
    assertEquals(List.of("Robots", "Follow the robot", "Stop All Robots", "Show Natalie"), found("robot"));
  }

  @Test
  void allWordsMustBeThereInAnyOrder() {
    assertEquals(List.of("Follow the robot"), found("robot map follow"));
    assertEquals(List.of(), found("robot nowhere"));
    assertEquals(5, found(" ").size());
  }

  private List<String> found(String words) {
    return SearchEntry.find(all, words).stream().map(SearchEntry::label).toList();
  }

  private static SearchEntry entry(String group, String label) {
    return new SearchEntry(group, label, "", () -> {});
  }
}
