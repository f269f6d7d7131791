package org.robotui.workbench.internal.model;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class AlertsTest {
  private long now = -5;
  private final Alerts alerts = new Alerts(() -> now);

  @Test
  void anAlertStaysUntilItIsSeenOff() {
    alerts.tell("Keira", "battery low");
    now += 100 * Alerts.NOTICE_NANOS;
    assertEquals("Keira: battery low", alerts.text());

    alerts.dismiss();
    assertEquals("", alerts.text());
  }

  @Test
  void theNewestAlertIsSaid() {
    alerts.tell("Keira", "battery low");
    alerts.tell("", "the memory is used up");

    assertEquals("the memory is used up", alerts.text());
  }

  @Test
  void aNoticeGoesByItselfAndUncoversTheAlert() {
    alerts.tell("Keira", "battery low");
    alerts.pass("the display answers again");
    assertEquals("the display answers again", alerts.text());

    now += Alerts.NOTICE_NANOS + 1;
    assertEquals("Keira: battery low", alerts.text());
  }

  @Test
  void whoSeesOffANoticeKeepsTheAlertBelow() {
    alerts.tell("Keira", "battery low");
    alerts.pass("the display answers again");
    alerts.dismiss();

    assertEquals("Keira: battery low", alerts.text());
  }

  @Test
  void anAlertIsMoreThanANotice() {
    alerts.pass("the display answers again");
    alerts.tell("Keira", "battery low");

    assertEquals("Keira: battery low", alerts.text());
  }
}
