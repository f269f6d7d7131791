package org.robotui.ui.show;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.custom.StyledText;
import org.eclipse.swt.dnd.Clipboard;
import org.eclipse.swt.dnd.TextTransfer;
import org.eclipse.swt.widgets.Event;
import org.eclipse.swt.widgets.Menu;
import org.eclipse.swt.widgets.MenuItem;
import org.eclipse.swt.widgets.Shell;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.api.host.PortStatus;
import org.robotui.api.host.RuicSnapshot;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.PortKind;
import org.robotui.api.port.SourceId;
import org.robotui.api.show.Showing;
import org.robotui.api.show.Subject;
import org.robotui.data.Data;
import org.robotui.data.FrameId;
import org.robotui.data.joint.JointState;
import org.robotui.testkit.Displays;
import org.robotui.testkit.FakeAuthority;
import org.robotui.testkit.FakeRuicView;
import org.robotui.testkit.FakeShowings;
import org.robotui.testkit.TestDisplay;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.ui.control.PopupMenu;

@EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
class SubjectMenuSwtTest {
  private static final SourceId JOINTS = new SourceId("base", "/joint_states");
  private static final Showing ECHO = Showing.streams("echo", "Echo", List.of(Data.class));
  private static final Showing PLOT = Showing.numbers("plot", "Plot");
  private static final Showing MAP = Showing.streams("map", "Show in Map", List.of());

  private final FakeRuicView ruic = new FakeRuicView(new FakeAuthority("Keira"));
  private final FakeShowings views = ruic.showings();
  private Shell shell;
  private Theme theme;
  private SubjectMenu menus;

  @BeforeEach
  void open() {
    shell = new Shell(TestDisplay.get());
    theme = Themes.light(TestDisplay.get());
    menus = new SubjectMenu(ruic, theme, Runnable::run);
    RuicSnapshot now = ruic.snapshot();
    ruic.snapshot(new RuicSnapshot(now.name(), now.state(), "", now.link(), now.components(),
        List.of(new PortStatus(JOINTS, PortKind.STREAM, "JointState", true, 1, 10, 0.1, false, 0, "", "")),
        now.matches()));
    views.offer("topics", ECHO).offer("plot", PLOT).refuse(MAP, "shows no JointState");
  }

  @AfterEach
  void close() {
    shell.dispose();
    theme.dispose();
  }

  @Test
  void aPortHasTheViewsThatShowItItsNameItsValueAndItsDocumentation() {
    value(1.5);
    assertEquals(List.of("Echo", "Plot", "Show in Map  (shows no JointState)", "Copy name", "Copy value as YAML",
        "Copy value as JSON",
        "Documentation of JointState"), words(menu(Subject.Stream.of(JOINTS))));
  }

  @Test
  void whatCannotBeDoneIsDisabledAndSaysWhy() {
    Menu menu = menu(Subject.Stream.of(JOINTS));
    assertFalse(item(menu, "Show in Map  (shows no JointState)").isEnabled());
    assertFalse(item(menu, "Copy value as JSON  (no value yet)").isEnabled());
  }

  @Test
  void theNumbersOfAPortAreInAMenuOfTheirOwn() {
    value(1.5);
    Menu fields = item(menu(Subject.Stream.of(JOINTS)), "Plot").getMenu();
    assertEquals(List.of("joints[0].position", "joints[0].velocity", "joints[0].effort", "Choose among all\u2026"),
        words(fields));
    choose(item(fields, "joints[0].velocity"));
    assertEquals(new Subject.Stream(JOINTS, List.of("joints[0].velocity")), views.shown().getFirst().subject());
    assertEquals("plot", views.shown().getFirst().choice().view());
  }

  @Test
  void beforeTheFirstValueTheViewLetsTheUserChoose() {
    choose(item(menu(Subject.Stream.of(JOINTS)), "Plot\u2026"));
    assertEquals(Subject.Stream.of(JOINTS), views.shown().getFirst().subject());
  }

  @Test
  void aFieldIsPlottedAtOnceUnlessItIsNoNumber() {
    value(1.5);
    choose(item(menu(new Subject.Stream(JOINTS, List.of("joints[0].effort"))), "Plot"));
    assertEquals(List.of("joints[0].effort"), ((Subject.Stream) views.shown().getFirst().subject()).fields());
    assertFalse(item(menu(new Subject.Stream(JOINTS, List.of("joints[0].name"))), "Plot  (no number)").isEnabled());
  }

  @Test
  void copiesNameValueOfAFieldAndJson() {
    value(1.5);
    choose(item(menu(Subject.Stream.of(JOINTS)), "Copy name"));
    assertEquals("/joint_states", clipboard());
    choose(item(menu(new Subject.Stream(JOINTS, List.of("joints[0].position"))), "Copy value"));
    assertEquals("1.5", clipboard());
    choose(item(menu(Subject.Stream.of(JOINTS)), "Copy value as JSON"));
    TestDisplay.until(() -> clipboard().startsWith("{"));
    assertTrue(clipboard().contains("\"position\": 1.5"), clipboard());
  }

  @Test
  void twoViewsOfOneTypeAreToldApartByTheirTitles() {
    views.offer("forces", PLOT);
    value(1.5);
    assertEquals(List.of("Plot (plot)", "Plot (forces)"),
        words(menu(Subject.Stream.of(JOINTS))).stream().filter(w -> w.startsWith("Plot")).toList());
  }

  @Test
  void framesAndNodesHaveTheViewsForThemAlone() {
    views.offer("scene", Showing.frames("frame", "Show in Scene"));
    assertEquals(List.of("Show in Scene", "Copy name"),
        words(menu(new Subject.Frame(new FrameId("Keira", "base_link")))));
    assertEquals(List.of("Copy name"), words(menu(new Subject.Node("/amcl"))));
  }

  @Test
  void theDocumentationSaysWhatTheFieldsMean() {
    shell.open();
    Shell window = TypeWindow.open(TestDisplay.get(), theme, "JointState", Optional.empty());
    StyledText text = (StyledText) window.getChildren()[0];
    assertTrue(text.getText().contains("position  double  radians or metres, NaN where unknown"), text.getText());
    window.dispose();
  }

  private void value(double position) {
    JointState joints = new JointState(List.of(new JointState.Joint("wrist", position, 0, 0)));
    views.newest(new Envelope<>(joints, JOINTS, 0, Optional.empty(), System.nanoTime(), Optional.empty()));
  }

  private Menu menu(Subject subject) {
    PopupMenu menu = new PopupMenu(shell);
    menus.fill(menu, subject);
    return menu.widget();
  }

  private static List<String> words(Menu menu) {
    return Arrays.stream(menu.getItems()).filter(item -> (item.getStyle() & SWT.SEPARATOR) == 0).map(MenuItem::getText)
        .toList();
  }

  private static MenuItem item(Menu menu, String words) {
    return Arrays.stream(menu.getItems()).filter(item -> item.getText().equals(words)).findFirst()
        .orElseThrow(() -> new AssertionError(words + " is not among " + words(menu)));
  }

  private static void choose(MenuItem item) {
    item.notifyListeners(SWT.Selection, new Event());
  }

  private static String clipboard() {
    Clipboard clipboard = new Clipboard(TestDisplay.get());
    String text = Optional.ofNullable((String) clipboard.getContents(TextTransfer.getInstance())).orElse("");
    clipboard.dispose();
    return text;
  }
}
