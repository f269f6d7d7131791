package org.robotui.ui.control;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.robotui.data.record.FieldPath;
import org.robotui.data.record.FieldValue;

class RecordRowsTest {
  private final RecordRows rows = new RecordRows();

  @Test
  void recordsWithinAreOpenAtFirstAndArraysClosed() {
    assertEquals(
        List.of("header", "header.seq", "header.stamp", "header.frame_id", "angle_min", "ranges", "intensities", "ok",
            "names", "poses"),
        paths(360));
  }

  @Test
  void whatWasOpenedStaysOpenInTheNextRecord() {
    rows.turn("names");
    rows.turn("header");
    List<String> first = paths(360);
    assertTrue(first.containsAll(List.of("names[0]", "names[1]")));
    assertFalse(first.contains("header.seq"));
    assertEquals(first, paths(10));
    rows.turn("names");
    assertFalse(paths(360).contains("names[0]"));
  }

  @Test
  void aLongArrayComesInPages() {
    rows.turn("ranges");
    assertTrue(paths(360).containsAll(List.of("ranges[0..99]", "ranges[300..359]")));
    rows.turn("ranges[300..359]");
    List<String> open = paths(360);
    assertTrue(open.contains("ranges[359]"));
    assertFalse(open.contains("ranges[299]"));
  }

  @Test
  void aVeryLongArrayComesInPagesOfPages() {
    rows.turn("ranges");
    rows.turn("ranges[90000..99999]");
    rows.turn("ranges[99900..99999]");
    List<String> open = paths(100_000);
    assertTrue(open.contains("ranges[99999]"));
    assertTrue(open.size() < 350, "only what is open is there, not " + open.size());
  }

  @Test
  void anArrayThatBecameShorterShowsWhatItHas() {
    rows.turn("ranges");
    rows.turn("ranges[300..359]");
    assertTrue(paths(310).contains("ranges[300..309]"));
    assertTrue(paths(50).contains("ranges[49]"));
  }

  @Test
  void allIsOpenedAndClosed() {
    rows.openAll();
    assertTrue(paths(360).contains("poses[1].position.x"));
    rows.closeAll();
    assertEquals(7, paths(360).size());
  }

  @Test
  void everyPathLeadsToTheValueShown() {
    rows.openAll();
    for (RecordRow row : rows.of(Records.scan(5, 0.25))) {
      FieldValue there = FieldPath.parse(row.fieldPath()).in(Records.scan(5, 0.25)).orElseThrow();
      assertEquals(RecordText.line(there), RecordText.line(row), row.path());
    }
  }

  @Test
  void valuesAreWrittenAsOneWouldWriteThem() {
    assertEquals("0.1", RecordText.number(0.1f));
    assertEquals("0.1", RecordText.number(0.1));
    assertEquals("-3", RecordText.number(-3));
    assertEquals("NaN", RecordText.number(Double.NaN));
    assertEquals("1.5E300", RecordText.number(1.5e300));
    assertEquals("18446744073709551615",
        RecordText.line(new FieldValue.Num(1.8446744073709552E19, "18446744073709551615")));
    assertEquals("1763737178.123456789", RecordText.line(new FieldValue.Time(1_763_737_178_123_456_789L)));
    assertEquals("-0.500000000", RecordText.line(new FieldValue.Time(-500_000_000L)));
    assertEquals("[2]  left, right", RecordText.line(Records.scan(1, 0).field("names").orElseThrow()));
  }

  @Test
  void aCopiedRecordReadsLikeTheToolsOfRobots() {
    String text = RecordText.full(new FieldValue.Nested(Records.scan(2, 1)));
    assertTrue(text.startsWith("header:\n  seq: 42\n  stamp: 1763737178.123456789\n"), text);
    assertTrue(text.contains("ranges: [1, 1.5]\n"), text);
    assertTrue(text.endsWith("poses:\n  -\n    position:\n      x: 1.0\n  -\n    position:\n      x: 2.0"), text);
  }

  private List<String> paths(int rays) {
    return rows.of(Records.scan(rays, 0.25)).stream().map(RecordRow::path).toList();
  }
}
