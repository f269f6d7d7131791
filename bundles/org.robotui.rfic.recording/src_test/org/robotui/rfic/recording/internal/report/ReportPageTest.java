package org.robotui.rfic.recording.internal.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.StringReader;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Test;
import org.robotui.data.FrameId;
import org.robotui.data.array.Bytes;
import org.robotui.data.array.Doubles;
import org.robotui.data.image.CompressedImage;
import org.robotui.data.image.PixelEncoding;
import org.robotui.data.image.RawImage;
import org.robotui.data.navigation.NavigationStatus;
import org.robotui.data.navigation.Odometry;
import org.robotui.data.record.FieldValue;
import org.robotui.data.record.MapRecord;
import org.robotui.data.sensor.Battery;
import org.robotui.data.status.Diagnostics;
import org.robotui.data.status.LogEntry;
import org.robotui.data.status.Severity;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.rfic.recording.internal.ToldHistory;
import org.w3c.dom.Document;
import org.w3c.dom.NodeList;
import org.xml.sax.InputSource;

class ReportPageTest {
  private static final FrameId ODOM = new FrameId("robot", "odom");
  private static final FrameId CAMERA = new FrameId("robot", "camera");

  private final ToldHistory history = new ToldHistory();

  private static Odometry odometry(double x, double speed) {
    return new Odometry(ODOM, new FrameId("robot", "base"), RigidTransform.planar(x, 0, 0), Doubles.EMPTY,
        new Vector3(speed, 0, 0), Vector3.ZERO, Doubles.EMPTY);
  }

  private Document page() throws Exception {
    String text = ReportPage.of(new ReportedFile("run & test.mcap", List.of("byte 7: <cut> off")), history,
        history.span());
    return DocumentBuilderFactory.newInstance().newDocumentBuilder().parse(new InputSource(new StringReader(text)));
  }

  private static List<String> all(Document page, String element) {
    NodeList found = page.getElementsByTagName(element);
    return IntStream.range(0, found.getLength()).mapToObj(i -> found.item(i).getTextContent()).toList();
  }

  private static Diagnostics motor(Diagnostics.Level level, String message) {
    return new Diagnostics(List.of(new Diagnostics.Item("motor", "", level, message, Map.of())));
  }

  @Test
  void whatHappenedIsListedOnceWithHowOften() throws Exception {
    history.says("log", 1, new LogEntry(Severity.INFO, "node", "started", ""))
        .says("log", 2, new LogEntry(Severity.ERROR, "node", "no path to <script>alert(1)</script>", ""))
        .says("log", 3, new LogEntry(Severity.ERROR, "node", "no path to <script>alert(1)</script>", ""))
        .says("diagnostics", 4, motor(Diagnostics.Level.OK, ""))
        .says("diagnostics", 5, motor(Diagnostics.Level.WARNING, "hot"))
        .says("diagnostics", 6, motor(Diagnostics.Level.WARNING, "hot"))
        .says("status", 7, new NavigationStatus("1", NavigationStatus.State.ABORTED, "stuck"));
    List<String> cells = all(page(), "td");
    assertEquals(List.of("1 s", "error", "node", "no path to <script>alert(1)</script> 2 times",
        "4 s", "warning", "motor", "warning: hot", "6 s", "error", "status", "goal aborted: stuck"),
        cells.subList(0, 12));
    assertEquals(0, all(page(), "script").size());
  }

  private static MapRecord event(String what, String subject, String value, String text) {
    Map<String, FieldValue> fields = new LinkedHashMap<>();
    fields.put("event", new FieldValue.Text(what));
    fields.put("ui", new FieldValue.Text("Natalie"));
    fields.put("subject", new FieldValue.Text(subject));
    fields.put("value", new FieldValue.Text(value));
    fields.put("text", new FieldValue.Text(text));
    return new MapRecord("robotui.Event", fields);
  }

  @Test
  void whatRobotUiNotedIsSaidInSentences() throws Exception {
    history.says("events", 0, event("control", "Natalie", "", ""))
        .says("events", 1, event("stop", "Natalie", "You", ""))
        .says("events", 2, event("link", "base", "failed", "connection reset"));
    List<String> cells = all(page(), "td");
    assertEquals(List.of("nobody controls Natalie", "Natalie is stopped by You", "link base failed: connection reset"),
        List.of(cells.get(3), cells.get(7), cells.get(11)));
  }

  @Test
  void whatIsDamagedStandsAbove() throws Exception {
    history.says("odom", 0, odometry(0, 0));
    assertEquals("run & test.mcap", all(page(), "h1").getFirst());
    assertEquals("byte 7: <cut> off", all(page(), "li").getFirst());
  }

  @Test
  void aPathIsMeasuredWithoutItsJumps() throws Exception {
    for (int i = 0; i <= 100; i++) {
      history.says("odom", i * 0.1, odometry(i * 0.1, 1));
    }
    history.says("odom", 10.1, odometry(60, 1));
    assertTrue(all(page(), "li").contains("odom: 10.00 m, one jump, from (0.00, 0.00) to (60.00, 0.00)"),
        () -> all(pageOrFail(), "li").toString());
  }

  private Document pageOrFail() {
    try {
      return page();
    } catch (Exception e) {
      throw new AssertionError(e);
    }
  }

  @Test
  void speedAndBatteryHaveTheirFigures() throws Exception {
    history.says("odom", 0, odometry(0, 0.5)).says("battery", 1, new Battery(12, 1, 0.8, Battery.Status.DISCHARGING))
        .says("odom", 2, odometry(1, -1.5));
    List<String> captions = all(page(), "figcaption");
    assertTrue(captions.contains("odom speed, m/s lowest 0.50, mean 1.00, highest 1.50"), captions::toString);
    assertTrue(captions.contains("battery charge, % lowest 80.00, mean 80.00, highest 80.00"), captions::toString);
  }

  @Test
  void picturesOfACameraAreSpreadOverTheTimeAndStandInThePage() throws Exception {
    byte[] jpeg = {(byte) 0xff, (byte) 0xd8, 0, 0};
    for (int i = 0; i <= 30; i++) {
      history.says("front", i, new CompressedImage(CAMERA, "jpeg", Bytes.of(jpeg)));
      history.says("raw", i, new RawImage(CAMERA, 2, 1, PixelEncoding.BGR8, false, 6, Bytes.of(new byte[6])));
      history.says("depth", i, new RawImage(CAMERA, 1, 1, PixelEncoding.F32C1, false, 4, Bytes.of(new byte[4])));
    }
    Document page = page();
    assertEquals(List.of("0 s", "10 s", "20 s", "30 s"), all(page, "figcaption").subList(0, 4));
    NodeList images = page.getElementsByTagName("img");
    assertEquals(8, images.getLength());
    assertEquals("data:image/jpeg;base64,/9gAAA==",
        images.item(0).getAttributes().getNamedItem("src").getTextContent());
    assertTrue(images.item(4).getAttributes().getNamedItem("src").getTextContent().startsWith("data:image/png;"));
    assertEquals(1, all(page, "p").stream().filter(each -> each.startsWith("Some of its pictures")).count());
  }

  @Test
  void whereMessagesAreMissingIsSaid() throws Exception {
    for (int i = 0; i < 100; i++) {
      history.says("odom", i < 50 ? i * 0.1 : 8 + i * 0.1, odometry(0, 0));
    }
    assertTrue(all(page(), "td").contains("8.10 s at 4.90 s"), () -> all(pageOrFail(), "td").toString());
  }

  @Test
  void aRecordingOfOneMomentIsShown() throws Exception {
    history.says("odom", 5, odometry(0, 0));
    assertTrue(all(page(), "p").getFirst().contains("1 message of 1 topic"), () -> all(pageOrFail(), "p").toString());
  }

  @Test
  void manyPlacesBecomeNoMoreThanAFigureShows() {
    DrivenPath path = new DrivenPath("odom", "odom", Vector3.ZERO);
    for (int i = 0; i <= 100_000; i++) {
      path.take(new Vector3(i * 0.001, 0, 0));
    }
    assertTrue(path.places().size() < 4001 && path.places().size() > 1000, () -> path.places().size() + "");
    assertEquals(100, path.length(), 1e-6);
  }

  @Test
  void timesHaveTheirUnits() {
    assertEquals(List.of("0 s", "2.50 s", "1:05", "1:00:01"),
        List.of(TimeAxis.words(0), TimeAxis.words(2.5), TimeAxis.words(65), TimeAxis.words(3601)));
    assertEquals(List.of("59 s", "1:05 min", "1:00:01 h"),
        List.of(TimeAxis.length(59), TimeAxis.length(65), TimeAxis.length(3601)));
  }
}
