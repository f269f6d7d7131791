package org.robotui.ui.show;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.api.port.SourceId;
import org.robotui.api.show.Subject;
import org.robotui.testkit.Displays;
import org.robotui.testkit.TestDisplay;

@EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
class PortTransferTest {
  private static final DraggedPorts PORTS = new DraggedPorts("Keira", List.of(
      new Subject.Stream(new SourceId("base", "/odom"), List.of("linear.x", "angular.z")),
      Subject.Stream.of(new SourceId("arm", "/joint_states"))));

  @Test
  void whatIsDraggedArrivesWhole() {
    TestDisplay.get();
    assertEquals(Optional.of(PORTS), PortTransfer.ports(PortTransfer.bytes(PORTS)));
  }

  @Test
  void whatIsCutOrForeignIsNothing() {
    TestDisplay.get();
    byte[] bytes = PortTransfer.bytes(PORTS);
    for (int length = 0; length < bytes.length; length++) {
      assertEquals(Optional.empty(), PortTransfer.ports(Arrays.copyOf(bytes, length)), "cut after " + length);
    }
    assertEquals(Optional.empty(),
        PortTransfer.ports("GET / HTTP/1.1\r\n\r\n".repeat(20).getBytes(StandardCharsets.US_ASCII)));
    assertEquals(Optional.empty(), PortTransfer.ports(new byte[]{0, 0, 0x7f, -1, -1, -1}));
  }

  @Test
  void otherProgramsGetTheNamesOfTheRobot() {
    assertEquals("/odom", PortDrag.name(Subject.Stream.of(new SourceId("base", "/odom"))));
    assertEquals("base./odom:linear.x\nbase./odom:angular.z", PortDrag.name(PORTS.streams().getFirst()));
  }
}
