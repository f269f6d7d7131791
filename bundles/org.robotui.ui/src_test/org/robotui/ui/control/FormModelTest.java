package org.robotui.ui.control;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigInteger;
import java.time.Clock;
import java.time.Instant;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.robotui.data.array.Doubles;
import org.robotui.data.record.FieldShape;
import org.robotui.data.record.FieldValue;
import org.robotui.data.record.MapRecord;
import org.robotui.data.record.RecordShape;

class FormModelTest {
  private static final Clock CLOCK = Clock.fixed(Instant.ofEpochSecond(100, 5), ZoneOffset.UTC);

  private final FormModel form = new FormModel(Shapes.TASK, CLOCK);

  @Test
  void anEmptyFormIsAllZeros() {
    Map<String, Object> values = form.values().orElseThrow();
    assertEquals(List.of("header", "mode", "speed", "loop", "label", "timeout", "goal", "covariance", "way", "names"),
        List.copyOf(values.keySet()));
    assertEquals(Map.of("seq", 0L, "stamp", 0L, "frame_id", ""), values.get("header"));
    assertEquals(List.of(0.0, 0.0, 0.0, 0.0), values.get("covariance"));
    assertEquals(List.of(), values.get("way"));
    assertEquals(Boolean.FALSE, values.get("loop"));
  }

  @ParameterizedTest
  @CsvSource({"8,true,-128,127", "8,false,0,255", "16,true,-32768,32767", "32,false,0,4294967295",
      "64,true,-9223372036854775808,9223372036854775807", "64,false,0,18446744073709551615"})
  void wholeNumbersKeepTheirRange(int bits, boolean signed, BigInteger least, BigInteger most) throws Exception {
    FieldShape shape = new FieldShape.Whole(bits, signed);
    FormInput input = new FormInput(CLOCK);
    assertEquals(most.toString(), input.read(shape, most.toString()).toString());
    assertEquals(least.toString(), input.read(shape, least.toString()).toString());
    assertEquals("must be from " + least + " to " + most, refusal(shape, most.add(BigInteger.ONE).toString()));
    assertEquals("must be from " + least + " to " + most, refusal(shape, least.subtract(BigInteger.ONE).toString()));
  }

  @Test
  void numbersAreReadAsRobotsWriteThem() throws Exception {
    FormInput input = new FormInput(CLOCK);
    assertEquals(255L, input.read(new FieldShape.Whole(8, false), "0xFF"));
    assertEquals(Double.NaN, input.read(new FieldShape.Real(64), "nan"));
    assertEquals(Double.NEGATIVE_INFINITY, input.read(new FieldShape.Real(32), "-inf"));
    assertEquals(1.5e-3, input.read(new FieldShape.Real(64), " 1.5e-3 "));
    assertEquals(1.5, input.read(new FieldShape.Real(64), "1,5"));
    assertEquals(100_000_000_005L, input.read(new FieldShape.Time(), "now"));
    assertEquals(1_500_000_000L, input.read(new FieldShape.Time(), "1.5"));
    assertEquals(-250_000_000L, input.read(new FieldShape.Duration(), "-0.25 s"));
    assertEquals(List.of(1L, 2L, 3L), input.read(new FieldShape.Many(new FieldShape.Whole(8, true), 0), "[1, 2  3]"));
  }

  @Test
  void refusalsSayWhatToWrite() {
    assertEquals("is no number; decimals begin with a point", refusal(new FieldShape.Real(64), "1,500"));
    assertEquals("is no number", refusal(new FieldShape.Real(64), "1f"));
    assertEquals("is no number", refusal(new FieldShape.Real(64), "0x1p3"));
    assertEquals("is neither true nor false", refusal(new FieldShape.Flag(), "maybe"));
    assertEquals("is too large for single precision", refusal(new FieldShape.Real(32), "1e39"));
    assertEquals("is too large", refusal(new FieldShape.Real(64), "1e999"));
    assertEquals("is no time: write seconds, or now", refusal(new FieldShape.Time(), "soon"));
    assertEquals("must be from 0 to 4294967295 seconds", refusal(new FieldShape.Time(), "-1"));
    assertEquals("is no duration: write seconds", refusal(new FieldShape.Duration(), "1e99"));
    FieldShape.Many two = new FieldShape.Many(new FieldShape.Whole(8, false), 2);
    assertEquals("needs 2 numbers, not 3", refusal(two, "1 2 3"));
    assertEquals("[1] '300' must be from 0 to 255", refusal(two, "1 300"));
  }

  @Test
  void problemsNameTheField() {
    leaf("goal", "x").text("far");
    assertTrue(form.values().isEmpty());
    assertEquals(List.of(new FormProblem("goal.x", "is no number")), form.problems());
    leaf("goal", "x").text("2");
    assertEquals(Map.of("x", 2.0, "y", 0.0), form.values().orElseThrow().get("goal"));
  }

  @Test
  void constantsAreOfferedWhereTheyFitAndMayBeTyped() {
    FormLeaf mode = leaf("mode");
    assertEquals(List.of("MODE_IDLE", "MODE_DRIVE"), mode.choices().stream().map(RecordShape.Constant::name).toList());
    assertEquals(List.of("FRAME"), leaf("label").choices().stream().map(RecordShape.Constant::name).toList());
    mode.text("MODE_DRIVE");
    assertEquals(2L, form.values().orElseThrow().get("mode"));
  }

  @Test
  void elementsAreAddedAndThoseBehindARemovedOneMoveUp() {
    FormArray way = (FormArray) node("way");
    way.add();
    way.add();
    way.add();
    for (int i = 0; i < 3; i++) {
      ((FormLeaf) ((FormGroup) way.elements().get(i)).fields().getFirst()).text(Integer.toString(i));
    }
    way.remove(1);
    assertEquals(List.of(Map.of("x", 0.0, "y", 0.0), Map.of("x", 2.0, "y", 0.0)), way.value());
    assertEquals("way[1]", way.elements().get(1).path());
  }

  @Test
  void aFormIsFilledFromARecordAndReset() {
    Map<String, FieldValue> fields = new LinkedHashMap<>();
    fields.put("mode", new FieldValue.Num(2, "2"));
    fields.put("speed", new FieldValue.Num(0.5f, "0.5"));
    fields.put("loop", new FieldValue.Flag(true));
    fields.put("timeout", new FieldValue.Time(2_500_000_000L));
    fields.put("covariance", new FieldValue.Numbers(Doubles.of(1, 2.5, 3, 4)));
    fields.put("names", new FieldValue.Items(List.of(new FieldValue.Text("a"), new FieldValue.Text("b"))));
    fields.put("label", new FieldValue.Nested(new MapRecord("x", Map.of())));
    form.fill(new MapRecord("demo_msgs/Task", fields));
    Map<String, Object> values = form.values().orElseThrow();
    assertEquals(2L, values.get("mode"));
    assertEquals(2_500_000_000L, values.get("timeout"));
    assertEquals(List.of(1.0, 2.5, 3.0, 4.0), values.get("covariance"));
    assertEquals(List.of("a", "b"), values.get("names"));
    assertEquals("", values.get("label"));
    form.root().reset();
    assertEquals(new FormModel(Shapes.TASK, CLOCK).values(), form.values());
  }

  @Test
  void aLongArrayIsKeptAsItCame() {
    FieldShape bytes = new FieldShape.Many(new FieldShape.Whole(8, false), 0);
    FormModel image = new FormModel(Shapes.shape("Image", Shapes.field("data", bytes)), CLOCK);
    image.fill(new MapRecord("Image", Map.of("data", new FieldValue.Numbers(Doubles.wrap(new double[300_000])))));
    assertEquals(300_000, ((List<?>) image.values().orElseThrow().get("data")).size());
    assertEquals("300000 numbers as received", ((FormLeaf) image.root().fields().getFirst()).text());
  }

  private static String refusal(FieldShape shape, String text) {
    List<FormProblem> problems = new ArrayList<>();
    FormLeaf leaf = new FormLeaf("f", "f", shape, List.of(), new FormInput(CLOCK));
    leaf.text(text);
    leaf.problems(problems);
    return problems.getFirst().sentence();
  }

  private FormNode node(String name) {
    return form.root().fields().stream().filter(field -> field.name().equals(name)).findFirst().orElseThrow();
  }

  private FormLeaf leaf(String name) {
    return (FormLeaf) node(name);
  }

  private FormLeaf leaf(String group, String name) {
    return (FormLeaf) ((FormGroup) node(group)).fields().stream().filter(f -> f.name().equals(name)).findFirst()
        .orElseThrow();
  }
}
