package org.robotui.rfic.rosbridge.internal.session;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.robotui.rosbridge.RosApi.NodeDetails;

class NodeSurveyTest {
  private static final Set<String> TOPICS = Set.of("/scan");
  private static final List<String> MANY = IntStream.range(0, 70).mapToObj(i -> "/n" + i).toList();

  private final NodeSurvey survey = new NodeSurvey();

  private List<String> look(Set<String> topics, List<String> names, boolean looked) {
    List<String> all = new ArrayList<>();
    survey.begin(topics, names, looked);
    for (Optional<String> next = survey.next(); next.isPresent(); next = survey.next()) {
      all.add(next.get());
      survey.answered(next.get(), Optional.of(publishing("/of" + next.get())));
    }
    return all;
  }

  private static NodeDetails publishing(String topic) {
    return new NodeDetails(List.of(), List.of(topic), List.of());
  }

  private void settle(Set<String> topics) {
    Set<String> met = new HashSet<>();
    for (int i = 0; i < 4; i++) {
      List<String> some = look(topics, MANY, false);
      assertTrue(some.size() <= NodeSurvey.MOST_A_LOOK);
      met.addAll(some);
    }
    assertEquals(Set.copyOf(MANY), met);
  }

  @Test
  void allAreAskedInTurnsAndThenOneAtALook() {
    settle(TOPICS);
    assertEquals(MANY.size(), survey.nodes().size());
    Set<String> met = new HashSet<>();
    MANY.forEach(each -> {
      List<String> one = look(TOPICS, MANY, false);
      assertEquals(1, one.size());
      met.addAll(one);
    });
    assertEquals(Set.copyOf(MANY), met);
  }

  @Test
  void moreAreAskedWhileSomebodyLooksAndNobodyTwice() {
    settle(TOPICS);
    assertEquals(NodeSurvey.MOST_A_LOOK, look(TOPICS, MANY, true).size());
    assertEquals(List.of("/a", "/b"), look(TOPICS, List.of("/a", "/b"), true).stream().sorted().toList());
    assertEquals(2, look(TOPICS, List.of("/a", "/b"), true).size());
  }

  @Test
  void whoCameLastIsAskedFirst() {
    survey.begin(TOPICS, MANY, false);
    List<String> more = new ArrayList<>(MANY);
    more.add("/new");
    assertEquals("/new", look(TOPICS, more, false).getFirst());
  }

  @Test
  void afterTopicsHaveChangedThoseWhoHadThemAreAskedAndThenAll() {
    Set<String> two = Set.of("/scan", "/of/n5");
    settle(two);
    List<String> first = look(TOPICS, MANY, false);
    assertEquals("/n5", first.getFirst());
    assertEquals(NodeSurvey.MOST_A_LOOK, first.size());
    Set<String> met = new HashSet<>(first);
    IntStream.range(0, 3).forEach(i -> met.addAll(look(TOPICS, MANY, false)));
    assertEquals(Set.copyOf(MANY), met);
    assertEquals(1, look(TOPICS, MANY, false).size());
  }

  @Test
  void whoDoesNotAnswerDoesNotKeepOthersWaiting() {
    survey.begin(TOPICS, List.of("/silent", "/other"), false);
    Set<String> met = new HashSet<>();
    for (Optional<String> next = survey.next(); next.isPresent(); next = survey.next()) {
      met.add(next.get());
      survey.answered(next.get(), Optional.empty());
    }
    assertEquals(Set.of("/silent", "/other"), met);
    assertEquals(List.of(), survey.nodes().get("/silent").publishing());
    assertEquals(1, look(TOPICS, List.of("/silent", "/other"), false).size());
  }
}
