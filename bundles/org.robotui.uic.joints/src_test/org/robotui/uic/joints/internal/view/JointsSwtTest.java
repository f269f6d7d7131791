package org.robotui.uic.joints.internal.view;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.OptionalInt;
import java.util.stream.IntStream;
import org.eclipse.swt.SWT;
import org.eclipse.swt.dnd.Clipboard;
import org.eclipse.swt.dnd.TextTransfer;
import org.eclipse.swt.layout.FillLayout;
import org.eclipse.swt.widgets.Event;
import org.eclipse.swt.widgets.Shell;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.api.port.InputState;
import org.robotui.api.port.SourceId;
import org.robotui.data.joint.JointState.Joint;
import org.robotui.testkit.Displays;
import org.robotui.testkit.FakeAuthority;
import org.robotui.testkit.FakeRuicView;
import org.robotui.testkit.TestDisplay;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.ui.UiContext;
import org.robotui.ui.show.SubjectMenu;
import org.robotui.uic.joints.internal.model.Export;
import org.robotui.uic.joints.internal.model.JointColumn;
import org.robotui.uic.joints.internal.model.JointRow;
import org.robotui.uic.joints.internal.model.JointUnit;
import org.robotui.uic.joints.internal.model.JointsLook;
import org.robotui.uic.joints.internal.model.SourceRow;
import org.robotui.uic.joints.internal.model.Span;

@EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
class JointsSwtTest {
  private static final SourceId ARM = new SourceId("base", "/joint_states");
  private static final SourceId GRIPPER = new SourceId("base", "/gripper");

  private Shell shell;
  private Theme theme;
  private String note = "";
  private JointsSurface surface;

  @BeforeEach
  void open() {
    shell = new Shell(TestDisplay.get(), SWT.NO_TRIM);
    theme = Themes.of(TestDisplay.get(), "dark");
    shell.setLayout(new FillLayout());
    shell.setBounds(0, 0, 900, 400);
    surface = new JointsSurface(shell, UiContext.of(theme, text -> note = text), "Robot",
        new SubjectMenu(new FakeRuicView(new FakeAuthority("Robot")), theme, Runnable::run));
    shell.open();
  }

  @AfterEach
  void close() {
    shell.dispose();
    theme.dispose();
  }

  @Test
  void listsJointsAndSaysHowMany() {
    show(look(row(ARM, "shoulder", 1), row(ARM, "elbow", 2)));
    assertEquals(List.of("shoulder", "elbow"), names());
    assertEquals("2 joints", note);
  }

  @Test
  void theFilterIsInForceWhileTyping() {
    show(look(row(ARM, "shoulder", 1), row(ARM, "elbow", 2)));
    surface.filterField().words("elb");
    assertEquals(List.of("elbow"), names());
    show(look(row(ARM, "shoulder", 1), row(ARM, "elbow", 3)));
    assertEquals(List.of("elbow"), names(), "also for what comes later");
    surface.filterField().words("");
    assertEquals(2, names().size());
  }

  @Test
  void aSecondSourceBringsAColumnAndKeepsOrderAndSelection() {
    show(look(row(ARM, "shoulder", 1), row(ARM, "elbow", 2)));
    JointTable before = surface.current();
    before.sort(new JointTable.Sorting(JointColumn.POSITION, true));
    before.list().select(row(ARM, "elbow", 2).key());
    show(look(row(ARM, "shoulder", 1), row(ARM, "elbow", 2), row(GRIPPER, "finger", 3)));
    assertNotSame(before, surface.current());
    assertTrue(before.control().isDisposed());
    assertEquals(new JointTable.Sorting(JointColumn.POSITION, true), surface.current().sorting().orElseThrow());
    assertEquals(List.of("elbow"), surface.current().list().selected().stream().map(r -> r.joint().name()).toList());
    show(look(row(ARM, "shoulder", 1), row(ARM, "elbow", 2), row(GRIPPER, "finger", 3)));
    assertEquals(List.of("finger", "elbow", "shoulder"), names());
  }

  @Test
  void controlWithADigitSortsByTheColumnThere() {
    show(look(row(ARM, "shoulder", 1), row(ARM, "elbow", 2)));
    Event event = new Event();
    event.keyCode = '2';
    event.stateMask = SWT.MOD1;
    surface.current().list().control().notifyListeners(SWT.KeyDown, event);
    assertEquals(new JointTable.Sorting(JointColumn.POSITION, false), surface.current().sorting().orElseThrow());
    surface.current().list().control().notifyListeners(SWT.KeyDown, event);
    assertEquals(List.of("elbow", "shoulder"), names());
  }

  @Test
  void valuesAloneMakeNoOtherTable() {
    show(look(row(ARM, "shoulder", 1)));
    JointTable before = surface.current();
    show(look(row(ARM, "shoulder", 2)));
    assertSame(before, surface.current());
  }

  @Test
  void copiesWhatIsSelectedElseAll() {
    JointRow shoulder = row(ARM, "shoulder", 1);
    JointRow elbow = row(ARM, "elbow", 2);
    show(look(shoulder, elbow));
    surface.copyCsv();
    assertEquals(Export.csv(List.of(shoulder, elbow)), clipboard());
    surface.current().list().select(elbow.key());
    surface.copyYaml();
    assertEquals(Export.yaml(List.of(elbow)), clipboard());
  }

  @Test
  void fiveThousandJointsArePreparedAndShownWithoutAPause() {
    JointsLook look = look(IntStream.range(0, 5_000).mapToObj(i -> row(ARM, "joint_" + i, i)).toArray(JointRow[]::new));
    show(look);
    surface.current().sort(new JointTable.Sorting(JointColumn.JOINT, true));
    long best = Long.MAX_VALUE;
    for (int i = 0; i < 5; i++) {
      long start = System.nanoTime();
      surface.refresh();
      surface.control().update();
      best = Math.min(best, System.nanoTime() - start);
    }
    assertTrue(best < 16_000_000, "took " + best / 1_000 + " \u00b5s");
  }

  private void show(JointsLook look) {
    surface.prepare(look);
    surface.refresh();
  }

  private List<String> names() {
    return surface.current().list().rows().stream().map(row -> row.joint().name()).toList();
  }

  private static JointsLook look(JointRow... rows) {
    InputState live = new InputState.Live(10, 0.02);
    List<SourceRow> sources =
        List.of(rows).stream().map(JointRow::source).distinct().map(s -> new SourceRow(s, live, 1, 0.02)).toList();
    return new JointsLook(live, sources, List.of(rows), false, false);
  }

  private static JointRow row(SourceId source, String name, double position) {
    return new JointRow(source, new Joint(name, position, 0, Double.NaN), JointUnit.RADIANS, new Span(-1, 3, false),
        0.02, false,
        JointRow.Fields.ARRAYS, OptionalInt.of(0));
  }

  private String clipboard() {
    Clipboard clipboard = new Clipboard(shell.getDisplay());
    try {
      return (String) clipboard.getContents(TextTransfer.getInstance());
    } finally {
      clipboard.dispose();
    }
  }
}
