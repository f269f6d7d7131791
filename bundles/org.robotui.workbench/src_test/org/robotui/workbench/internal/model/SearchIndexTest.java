package org.robotui.workbench.internal.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

class SearchIndexTest {
  private final List<SearchEntry> all =
      List.of(entry("Map", "Follow the robot"), entry("View", "Log"), entry("Robot", "Show Natalie"),
          entry("Robot", "Stop All Robots"), entry("View", "Robots"), entry("Topic", "/front/image_raw"),
          entry("Topic", "/front/camera_info"), entry("Preferences", "jointStates"));
  private final SearchIndex index = new SearchIndex(all);

  @Test
  void whatBeginsWithTheWordsComesFirst() {
    assertEquals(List.of("Robots", "Follow the robot", "Stop All Robots", "Show Natalie"), found("robot"));
    assertEquals(List.of("/front/image_raw"), found("image"));
  }

  @Test
  void allWordsMustBeThereInAnyOrder() {
    assertEquals(List.of("Follow the robot"), found("robot map follow"));
    assertEquals(List.of(), found("robot nowhere"));
    assertEquals(all.size(), found(" ").size());
  }

  @Test
  void firstLettersAndLettersInTheirOrderAreEnough() {
    assertEquals(List.of("Stop All Robots"), found("sar"));
    assertEquals("/front/image_raw", found("fir").getFirst());
    assertEquals("Follow the robot", found("flw").getFirst());
    assertEquals(List.of("jointStates"), found("joist"));
    assertEquals(List.of(), found("rats"));
    assertEquals(List.of(), found("q"));
  }

  @Test
  void aWordWithinALabelComesBehindOneAtItsBeginning() {
    List<SearchEntry> more = Stream.concat(all.stream(), Stream.of(entry("Topic", "/robots"))).toList();
    List<SearchEntry> found = new SearchIndex(more).find("robots");

    assertEquals(List.of("Robots", "Stop All Robots", "/robots"), found.stream().map(SearchEntry::label).toList());
  }

  @Test
  void whateverIsTypedWhatIsFoundHasItsLettersAndNothingThatHasTheWordsIsMissed() {
    Random random = new Random(3);
    List<SearchEntry> many = IntStream.range(0, 300).mapToObj(i -> entry("Topic", word(random, 18))).toList();
    SearchIndex prepared = new SearchIndex(many);
    for (int i = 0; i < 500; i++) {
      String words = word(random, 4);
      List<SearchEntry> found = prepared.find(words);
      assertTrue(found.stream().allMatch(e -> isWithin(words.replace(" ", ""), e.label() + " topic")
          || words.chars().filter(c -> c != ' ').allMatch(c -> (e.label() + " topic").indexOf(c) >= 0)), words);
      assertTrue(found.containsAll(many.stream().filter(e -> e.label().contains(words.strip())).toList()), words);
      assertEquals(found.size(), found.stream().distinct().count());
    }
  }

  private static boolean isWithin(String letters, String text) {
    int at = 0;
    for (char c : letters.toCharArray()) {
      at = text.indexOf(c, at) + 1;
      if (at == 0) {
        return false;
      }
    }
    return true;
  }

  private static String word(Random random, int length) {
    return random.ints(length, 0, 9).mapToObj(i -> String.valueOf("abcdef/_ ".charAt(i)))
        .reduce("", String::concat);
  }

  private List<String> found(String words) {
    return index.find(words).stream().map(SearchEntry::label).toList();
  }

  private static SearchEntry entry(String group, String label) {
    return new SearchEntry(group, label, "", () -> {});
  }
}
