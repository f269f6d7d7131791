package org.robotui.ui.control;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Clock;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.FillLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Display;
import org.eclipse.swt.widgets.Event;
import org.eclipse.swt.widgets.Shell;
import org.eclipse.swt.widgets.Text;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.data.record.FieldValue;
import org.robotui.data.record.MapRecord;
import org.robotui.testkit.Displays;
import org.robotui.testkit.TestDisplay;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;

@EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
class RecordFormSwtTest {
  private final Display display = TestDisplay.get();
  private final List<String> told = new ArrayList<>();
  private Theme theme;
  private Shell shell;
  private RecordForm form;

  @BeforeEach
  void open() {
    theme = Themes.light(display);
    shell = new Shell(display);
    shell.setLayout(new FillLayout());
    form = new RecordForm(shell, theme, Clock.systemUTC()).onChange(() -> told.add("changed"));
    shell.setSize(420, 600);
    form.shape(Shapes.TASK);
    shell.open();
  }

  @AfterEach
  void close() {
    shell.dispose();
    theme.dispose();
  }

  @Test
  void whatIsTypedBecomesValues() {
    type("goal.x", "1.5");
    type("label", "go");
    form.body().rows().get("loop").input().notifyListeners(SWT.KeyDown, character(' '));
    Map<String, Object> values = form.values().orElseThrow();
    assertEquals(Map.of("x", 1.5, "y", 0.0), values.get("goal"));
    assertEquals("go", values.get("label"));
    assertEquals(Boolean.TRUE, values.get("loop"));
    assertEquals(3, told.size());
  }

  @Test
  void whatIsWrongIsSaidAndHoldsTheValuesBack() {
    type("mode", "256");
    assertTrue(form.values().isEmpty());
    assertEquals(List.of(new FormProblem("mode", "must be from 0 to 255")), form.problems());
    type("mode", "25");
    assertTrue(form.problems().isEmpty());
  }

  @Test
  void theSummaryLeadsIntoAClosedGroup() {
    assertFalse(form.body().rows().containsKey("header.seq"), "the header is closed at first");
    form.body().focus("header.seq");
    type("header.seq", "-1");
    assertTrue(form.body().rows().containsKey("header.seq"));
    form.showProblem();
    assertTrue(form.body().rows().get("header.seq").input().isFocusControl());
  }

  @Test
  void elementsAreAddedAndRemovedByButtons() {
    button("Add to names").press();
    button("Add to names").press();
    type("names[0]", "a");
    type("names[1]", "b");
    button("Remove names[0]").press();
    assertEquals(List.of("b"), form.values().orElseThrow().get("names"));
    assertEquals("b", ((Text) form.body().rows().get("names[0]").input()).getText());
  }

  @Test
  void theSameShapeKeepsWhatWasTypedAndAnotherDoesNot() {
    type("goal.x", "3");
    form.shape(Shapes.TASK);
    assertEquals("3", ((Text) form.body().rows().get("goal.x").input()).getText());
    form.shape(Shapes.POINT);
    assertEquals(Map.of("x", 0.0, "y", 0.0), form.values().orElseThrow());
  }

  @Test
  void aFilledFormShowsAndResetEmptiesIt() {
    Map<String, FieldValue> fields = new LinkedHashMap<>();
    fields.put("speed", new FieldValue.Num(0.5, "0.5"));
    form.fill(new MapRecord("demo_msgs/Task", fields));
    assertEquals("0.5", ((Text) form.body().rows().get("speed").input()).getText());
    form.reset();
    assertEquals("", ((Text) form.body().rows().get("speed").input()).getText());
  }

  @Test
  void ofManyElementsOnlySomeAreShownAndAllAreSent() {
    List<FieldValue> names = IntStream.range(0, 500).<FieldValue>mapToObj(i -> new FieldValue.Text("n" + i)).toList();
    form.fill(new MapRecord("demo_msgs/Task", Map.of("names", new FieldValue.Items(names))));
    form.body().focus("names[3]");
    assertTrue(form.body().rows().containsKey("names[49]"));
    assertFalse(form.body().rows().containsKey("names[50]"));
    assertEquals(500, ((List<?>) form.values().orElseThrow().get("names")).size());
  }

  @Test
  void controlAndEnterSubmit() {
    form.onSubmit(() -> told.add("submitted"));
    Event event = character(SWT.CR);
    event.keyCode = SWT.CR;
    event.stateMask = SWT.MOD1;
    form.body().rows().get("speed").input().notifyListeners(SWT.KeyDown, event);
    assertEquals(List.of("submitted"), told);
  }

  private void type(String path, String words) {
    ((Text) form.body().rows().get(path).input()).setText(words);
  }

  private static Event character(char character) {
    Event event = new Event();
    event.character = character;
    return event;
  }

  private QuietButton button(String hint) {
    return all(form.control()).filter(QuietButton.class::isInstance).map(QuietButton.class::cast)
        .filter(button -> hint.equals(button.getToolTipText())).findFirst().orElseThrow();
  }

  private static Stream<Control> all(Control control) {
    Stream<Control> within =
        control instanceof Composite parent ? Stream.of(parent.getChildren()).flatMap(RecordFormSwtTest::all)
            : Stream.of();
    return Stream.concat(Stream.of(control), within);
  }
}
