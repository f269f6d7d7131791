package org.robotui.uic.topics.internal.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.OptionalLong;
import org.junit.jupiter.api.Test;
import org.robotui.api.port.Input.Candidate;
import org.robotui.api.port.RawMessage;
import org.robotui.api.port.SourceId;
import org.robotui.data.array.Bytes;
import org.robotui.data.array.Doubles;
import org.robotui.data.record.FieldValue;
import org.robotui.data.record.MapRecord;
import org.robotui.testkit.FakeUicContext;
import org.robotui.testkit.KeptHistory;
import org.robotui.testkit.KeptTimeline;
import org.robotui.uic.topics.internal.TopicsOptions;
import org.robotui.uic.topics.internal.TopicsPorts;
import org.robotui.uic.topics.internal.model.MessageContent.FieldChange;

class RecordedTopicTest {
  private static final SourceId MODE = new SourceId("base", "mode");
  private static final long SECOND = KeptHistory.SECOND;
  private static final int COUNT = 2_000;

  private final KeptTimeline timeline = new KeptTimeline();
  private final KeptHistory history = new KeptHistory(timeline);
  private final FakeUicContext context = new FakeUicContext("topics", TopicsOptions.schema());
  private final RecordedTopic topic = new RecordedTopic(context.input(TopicsPorts.ALL), context.background());

  private static long at(double seconds) {
    return KeptHistory.BEGIN + Math.round(seconds * SECOND);
  }

  private static MapRecord message(int number) {
    return new MapRecord("demo/Mode", Map.of("number", new FieldValue.Num(number, Integer.toString(number)),
        "name", new FieldValue.Text(number < 5 ? "manual" : "auto")));
  }

  private void say(double seconds, int number) {
    byte[] bytes = ("mode " + number).getBytes(StandardCharsets.UTF_8);
    MapRecord record = message(number);
    history.add("mode", at(seconds), OptionalLong.empty(), record,
        Optional.of(new RawMessage("demo/Mode", "json", Bytes.of(bytes), any -> Optional.of(record))));
  }

  private void record() {
    for (int i = 0; i < COUNT; i++) {
      say(i, i);
    }
    context.input(TopicsPorts.ALL).candidates(List.of(new Candidate(MODE, "DynamicRecord")));
    context.input(TopicsPorts.ALL).history(MODE, history);
  }

  /** Until nothing more is read: a look, what it reads, and what that opens. */
  private MessageListing list(double seconds) {
    timeline.seek(at(seconds));
    topic.follow(Optional.of(MODE), "");
    topic.follow(Optional.of(MODE), "");
    return topic.follow(Optional.of(MODE), "");
  }

  @Test
  void messagesAroundThePositionAreListedAndTheOneThereIsOpened() {
    record();
    MessageListing listing = list(1000.5);
    assertEquals(2 * MessageRows.EACH, listing.rows().size());
    assertEquals(at(801), listing.rows().getFirst().time());
    TimedMessage current = listing.current().orElseThrow();
    assertEquals(new TimedMessage(at(1000), 0, OptionalLong.of(SECOND), OptionalInt.of(9)), current);
    MessageContent content = listing.content().orElseThrow();
    assertEquals("mode 1000", new String(bytes(content), StandardCharsets.UTF_8));
    assertEquals(List.of(new FieldChange("number", "999", "1000")), content.changes().orElseThrow());
    assertTrue(history.given() < COUNT, "the rest of the file is not read");
  }

  private static byte[] bytes(MessageContent content) {
    Bytes bytes = content.bytes().orElseThrow();
    byte[] copy = new byte[bytes.size()];
    bytes.copyTo(0, copy, 0, copy.length);
    return copy;
  }

  @Test
  void whatStandsIsNotReadAgainAndASmallMoveReadsTheMessageOnly() {
    record();
    MessageListing before = list(1000.5);
    int readings = history.readings();
    assertSame(before, list(1000.5));
    assertEquals(readings, history.readings());
    assertEquals(at(1020), list(1020.25).current().orElseThrow().time());
    assertEquals(readings + 1, history.readings());
    assertEquals(at(1500), list(1500).current().orElseThrow().time(), "a large one lists others");
  }

  @Test
  void atBothEndsAllIsListedThatThereIs() {
    record();
    MessageListing first = list(0);
    assertEquals(at(0), first.rows().getFirst().time());
    assertEquals(OptionalLong.empty(), first.rows().getFirst().gap());
    assertEquals(Optional.empty(), first.content().orElseThrow().changes());
    assertEquals(at(COUNT - 1), list(COUNT + 50).current().orElseThrow().time());
  }

  @Test
  void messagesOfOneTimeAreToldApart() {
    say(0, 1);
    say(1, 4);
    say(1, 5);
    say(2, 6);
    context.input(TopicsPorts.ALL).candidates(List.of(new Candidate(MODE, "DynamicRecord")));
    context.input(TopicsPorts.ALL).history(MODE, history);
    MessageListing listing = list(1.5);
    assertEquals(List.of(0, 0, 1, 0), listing.rows().stream().map(TimedMessage::place).toList());
    assertEquals(1, listing.current().orElseThrow().place());
    MessageContent content = listing.content().orElseThrow();
    assertEquals(Optional.of(new FieldValue.Num(5, "5")), content.record().field("number"));
    assertEquals(2, content.changes().orElseThrow().size());
  }

  @Test
  void aRecordingThatWasMovedIsListedWhereItLiesNow() {
    record();
    history.offset(100 * SECOND);
    MessageListing listing = list(150);
    assertEquals(at(50), listing.current().orElseThrow().time());
    listing.seek(listing.rows().getFirst());
    assertEquals(at(100), timeline.sought.getLast());
  }

  @Test
  void whatCannotBeListedIsExplained() {
    context.input(TopicsPorts.ALL).candidates(List.of(new Candidate(MODE, "DynamicRecord")));
    assertSame(MessageListing.NOTHING, topic.follow(Optional.empty(), ""));
    assertTrue(
        topic.follow(Optional.of(MODE), "").obstacle().startsWith("All messages are listed for recordings only"));
    assertEquals("Nobody publishes it.", topic.follow(Optional.empty(), "Nobody publishes it.").obstacle());
    record();
    history.fail("it is gone");
    assertEquals("The recording cannot be read: it is gone", list(10).obstacle());
  }

  @Test
  void arraysAreComparedByTheirElements() {
    MapRecord before = new MapRecord("demo/Scan", Map.of("ranges", new FieldValue.Numbers(Doubles.of(1, 2, 3))));
    MapRecord now = new MapRecord("demo/Scan", Map.of("ranges", new FieldValue.Numbers(Doubles.of(1, 2.5))));
    assertEquals(List.of(new FieldChange("ranges.length", "3", "2"), new FieldChange("ranges[1]", "2.0", "2.5"),
        new FieldChange("ranges[2]", "3.0", "")), FieldChanges.of(before, now));
  }
}
