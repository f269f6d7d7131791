package org.robotui.uic.alerts.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Clock;
import java.time.Instant;
import java.time.ZoneOffset;
import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.FillLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Event;
import org.eclipse.swt.widgets.Shell;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.api.alert.AlertEvent;
import org.robotui.api.alert.AlertId;
import org.robotui.api.alert.AlertWords;
import org.robotui.testkit.Displays;
import org.robotui.testkit.FakeAlerts;
import org.robotui.testkit.FakeUicContext;
import org.robotui.testkit.TestDisplay;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.ui.UiContext;
import org.robotui.ui.control.FilterField;
import org.robotui.ui.control.QuietButton;

@EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
class AlertsSwtTest {
  private final FakeUicContext context = new FakeUicContext("alerts", AlertsType.SCHEMA);
  private final AlertsUic uic = new AlertsUic(context, Clock.systemUTC());
  private Shell shell;
  private Theme theme;
  private String note = "";
  private Control view;

  @BeforeEach
  void open() {
    shell = new Shell(TestDisplay.get(), SWT.NO_TRIM);
    theme = Themes.of(TestDisplay.get(), "dark");
    shell.setLayout(new FillLayout());
    shell.setBounds(0, 0, 900, 300);
    context.alerts().raise("Battery low", "battery charge < 0.2", "battery.charge", "0.18");
    uic.tick(0);
    view = uic.createControl(shell, UiContext.of(theme, text -> note = text));
    shell.open();
  }

  @AfterEach
  void close() {
    shell.dispose();
    theme.dispose();
  }

  @Test
  void anAlertIsMutedAndAcknowledgedByKeys() {
    view.setFocus();
    Control list = TestDisplay.get().getFocusControl();
    assertEquals("1 new of 1", note);
    key(list, (char) 0, SWT.HOME);
    key(list, 'm', 'm');
    assertTrue(alertIsMuted());
    key(list, 'm', 'm');
    assertFalse(alertIsMuted());
    key(list, 'a', 'a');
    assertEquals("0 new of 1", note);
  }

  @Test
  void allAreMutedAndAcknowledgedByTheButtons() {
    button(0).press();
    assertTrue(context.alerts().allMutedUntil().isPresent());
    assertTrue(button(0).isChecked());
    button(0).press();
    assertFalse(context.alerts().allMutedUntil().isPresent());
    button(1).press();
    assertTrue(context.alerts().find("Battery low").orElseThrow().acknowledged());
    assertFalse(button(1).isEnabled(), "nothing waits any more");
  }

  @Test
  void theHistoryIsShownAndFilteredAndTheAlertsAgain() {
    AlertId id = new AlertId(FakeAlerts.VIEW, "Battery low");
    context.alerts().happened(new AlertEvent(Instant.now(), id, AlertEvent.Kind.BEGAN, "battery.charge", "0.18", ""));
    context.alerts().happened(new AlertEvent(Instant.now(), id, AlertEvent.Kind.ACKNOWLEDGED, "", "", "anna"));
    uic.tick(1);
    button(3).press();
    assertTrue(button(3).isChecked());
    assertFalse(button(0).isVisible());
    FilterField filter = (FilterField) bar().getChildren()[2];
    assertTrue(filter.isVisible());
    EventColumns columns = new EventColumns(new AlertWords(ZoneOffset.UTC));
    AlertEvent newest = context.alerts().history().getFirst();
    assertTrue(columns.fits(newest, "ANNA battery"));
    assertFalse(columns.fits(newest, "anna began"));
    key(TestDisplay.get().getFocusControl(), 'h', 'h');
    assertTrue(button(0).isVisible());
    assertFalse(filter.isVisible());
  }

  private boolean alertIsMuted() {
    return context.alerts().find("Battery low").flatMap(a -> a.mutedUntil()).isPresent();
  }

  private Composite bar() {
    return (Composite) ((Composite) view).getChildren()[0];
  }

  private QuietButton button(int number) {
    return Optional.of(bar().getChildren()[number]).map(QuietButton.class::cast).orElseThrow();
  }

  private static void key(Control control, char character, int code) {
    Event event = new Event();
    event.character = character;
    event.keyCode = code;
    control.notifyListeners(SWT.KeyDown, event);
  }
}
