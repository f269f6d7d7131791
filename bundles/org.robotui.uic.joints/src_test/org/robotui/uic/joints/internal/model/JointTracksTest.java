package org.robotui.uic.joints.internal.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import java.util.function.LongUnaryOperator;
import org.junit.jupiter.api.Test;
import org.robotui.api.port.InputState;
import org.robotui.api.port.RawMessage;
import org.robotui.api.port.SourceId;
import org.robotui.data.array.Bytes;
import org.robotui.data.joint.JointState;
import org.robotui.data.joint.JointState.Joint;
import org.robotui.testkit.FakeInput;

class JointTracksTest {
  private static final SourceId ARM = new SourceId("base", "/arm/joint_states");
  private static final SourceId BASE = new SourceId("base", "/joint_states");
  private static final long MS = 1_000_000;

  private final FakeInput<JointState> input = new FakeInput<>();
  private final FakeInput<JointState> messages = new FakeInput<>();
  private final JointTracks tracks = new JointTracks(LongUnaryOperator.identity());

  @Test
  void listsEveryJointOfEverySourceInTheOrderOfArrival() {
    put(BASE, 0, "left", "right");
    put(ARM, 0, "shoulder");
    JointsLook look = look(10 * MS);
    assertEquals(List.of("left", "right", "shoulder"), names(look));
    assertTrue(look.several());
    assertEquals("3 joints \u00b7 2 sources", look.note());
    assertEquals(0.01, look.joints().getFirst().ageSeconds(), 1e-9);
  }

  @Test
  void aJointThatStopsComingWhileOthersComeIsStale() {
    for (int i = 0; i < 50; i++) {
      put(ARM, i * 100 * MS, i < 20 ? new String[]{"shoulder", "elbow"} : new String[]{"shoulder"});
    }
    JointsLook look = look(4_900 * MS);
    assertFalse(row(look, "shoulder").stale());
    assertTrue(row(look, "elbow").stale());
    assertEquals(3, row(look, "elbow").ageSeconds(), 1e-9);
    assertEquals("2 joints \u00b7 1 stale", look.note());
  }

  @Test
  void aJointThatComesSeldomIsNotStaleWithinItsRhythm() {
    for (int i = 0; i <= 120; i++) {
      put(ARM, i * 100 * MS, i % 30 == 0 ? new String[]{"shoulder", "slow"} : new String[]{"shoulder"});
    }
    put(ARM, 19_000 * MS, "shoulder");
    assertFalse(row(look(19_000 * MS), "slow").stale(), "it came every 3 s, the last time 7 s ago");
  }

  @Test
  void allJointsOfAStaleSourceAreStale() {
    put(ARM, 0, "shoulder", "elbow");
    input.state(ARM, new InputState.Stale(4, "silent"));
    assertTrue(look(4_000 * MS).joints().stream().allMatch(JointRow::stale));
  }

  @Test
  void aSourceThatIsNoLongerConnectedIsForgotten() {
    put(ARM, 0, "shoulder");
    put(BASE, 0, "left");
    look(0);
    input.remove(ARM);
    assertEquals(List.of("left"), names(look(0)));
    assertFalse(look(0).several());
  }

  @Test
  void theRangeIsWhatWasSeenUntilItIsForgotten() {
    position(0, 1);
    position(1, -0.5);
    position(2, 0);
    assertEquals(new Span(-0.5, 1, false), look(2).joints().getFirst().span());
    tracks.forget();
    assertEquals(new Span(0, 0, false), look(2).joints().getFirst().span());
  }

  @Test
  void forgettingTakesSilentJointsAway() {
    put(ARM, 0, "gone", "shoulder");
    put(ARM, 9_000 * MS, "shoulder");
    assertEquals(List.of("gone", "shoulder"), names(look(9_000 * MS)));
    tracks.forget();
    assertEquals(List.of("shoulder"), names(look(9_000 * MS)));
  }

  @Test
  void configuredUnitsAndLimitsWin() {
    position(0, 7);
    JointOptions options =
        new JointOptions(true, Map.of("joint", JointUnit.METRES), Map.of("joint", new Span(0, 1, true)));
    tracks.take(input, messages, 0);
    JointRow row = tracks.look(input, options, 0).joints().getFirst();
    assertEquals(JointUnit.METRES, row.unit());
    assertTrue(row.span().isBeyond(row.joint().position()));
  }

  @Test
  void aRobotThatMakesUpNamesDoesNotFillTheMemory() {
    for (int i = 0; i < 10; i++) {
      int batch = i * 1_000;
      put(ARM, i, IntStream.range(0, 1_000).mapToObj(n -> "j" + (batch + n)).toArray(String[]::new));
    }
    JointsLook look = look(10);
    assertEquals(SourceTracks.MOST_JOINTS, look.joints().size());
    assertTrue(look.note().startsWith("5000 joints, more left out"), look.note());
  }

  @Test
  void theSearchWantsAllWords() {
    put(ARM, 0, "left_shoulder", "left_elbow");
    put(BASE, 0, "left_wheel");
    JointsLook look = look(0);
    assertEquals(List.of("left_elbow"), look.matching(" LEFT elb").stream().map(r -> r.joint().name()).toList());
    assertEquals(2, look.matching("/arm/").size());
    assertEquals(3, look.matching("").size());
    assertEquals(0, look.matching("nowhere").size());
  }

  @Test
  void theIndexIsThatOfTheMessageOfTheRobot() {
    put(ARM, 0, "a", "b");
    assertEquals(Optional.empty(), address(0, "b"), "what was merged tells nothing");
    assertEquals(Set.of(ARM), messages.chosen());
    message(true, "b", "a");
    assertEquals(Optional.of("position[0]"), address(1, "b"));
    assertEquals(Set.of(), messages.chosen(), "one message is enough");
  }

  @Test
  void aMessageIsAskedForAgainWhenJointsAreNewAndNowAndThen() {
    put(ARM, 0, "a");
    message(true, "a");
    look(1);
    look(2);
    assertEquals(Set.of(), messages.chosen());
    put(ARM, 3, "c");
    look(3);
    assertEquals(Set.of(ARM), messages.chosen());
    message(true, "c", "a");
    assertEquals(Optional.of("position[1]"), address(4, "a"));
    look(29_000 * MS);
    assertEquals(Set.of(), messages.chosen());
    look(31_000 * MS);
    assertEquals(Set.of(ARM), messages.chosen());
  }

  @Test
  void whereMessagesAreNeverKeptTheAddressesAreThoseOfOurRecords() {
    put(ARM, 0, "a", "b");
    message(false, "b", "a");
    message(false, "a", "b");
    assertEquals(Optional.empty(), address(0, "b"), "these may have been merged");
    message(false, "a", "b");
    assertEquals(Optional.of("joints[1].position"), address(1, "b"));
  }

  private Optional<String> address(long now, String joint) {
    return Address.field(row(look(now), joint), JointColumn.POSITION);
  }

  private void message(boolean kept, String... joints) {
    Optional<RawMessage> raw = kept
        ? Optional.of(new RawMessage("sensor_msgs/JointState", "ros1", Bytes.of(new byte[0]),
            bytes -> Optional.of(JointPlacesTest.message(joints))))
        : Optional.empty();
    messages.put(ARM, new JointState(Stream.of(joints).map(name -> new Joint(name, 0, 0, 0)).toList()), 0,
        Optional.empty(), raw);
  }

  private void position(long at, double position) {
    input.put(ARM, new JointState(List.of(new Joint("joint", position, 0, 0))), at, Optional.empty());
  }

  private void put(SourceId source, long at, String... joints) {
    input.put(source, new JointState(Stream.of(joints).map(name -> new Joint(name, 0, 0, 0)).toList()), at,
        Optional.empty());
  }

  private JointsLook look(long now) {
    tracks.take(input, messages, now);
    return tracks.look(input, JointOptions.NONE, now);
  }

  private static JointRow row(JointsLook look, String name) {
    return look.joints().stream().filter(row -> row.joint().name().equals(name)).findFirst().orElseThrow();
  }

  private static List<String> names(JointsLook look) {
    return look.joints().stream().map(row -> row.joint().name()).toList();
  }
}
