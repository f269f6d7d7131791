package org.robotui.uic.teleop.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.testkit.FakeAuthority;
import org.robotui.testkit.FakeOutput;
import org.robotui.testkit.FakeUicContext;
import org.robotui.data.command.VelocityCommand;
import org.robotui.uic.teleop.internal.PadHands.Wish;

class PadTest {
  private static final long MS = 1_000_000;
  private static final PadMapping USUAL = new PadMapping("auto", 1, 0, 4, 1);

  private final FakeUicContext context = new FakeUicContext("teleop", new TeleopType().schema());
  private final FakeAuthority authority = context.authority();
  private final FakeOutput<VelocityCommand> output = context.output(TeleopType.CMD_VEL);
  private final Driver driver =
      new Driver(output, context.input(TeleopType.ODOM), context.input(TeleopType.NAVIGATION), context.principal(),
          context.settings());
  private @TempDir Path folder;

  @Test
  void theStickDrivesOnlyWhileTheDeadManButtonIsHeld() {
    PadHands hands = new PadHands();

    assertEquals(Wish.NOTHING, hands.take(axis(1, -32767), USUAL));
    assertEquals(Optional.empty(), hands.stick());
    assertEquals(Wish.DRIVE, hands.take(button(4, 1), USUAL));
    assertEquals(new Stick(1, 0), hands.stick().orElseThrow());
    assertEquals(Wish.DRIVE, hands.take(axis(0, 32767), USUAL));
    assertEquals(new Stick(1, -1), hands.stick().orElseThrow());
    hands.take(axis(1, 2000), USUAL);
    assertEquals(0.0, hands.stick().orElseThrow().forward(), "a stick never comes back to its middle exactly");
    assertEquals(Wish.LET_GO, hands.take(button(4, 0), USUAL));
    assertEquals(Optional.empty(), hands.stick());
    assertEquals(Wish.STOP, hands.take(button(1, 1), USUAL));
    assertEquals(Wish.NOTHING, hands.take(button(1, 0), USUAL));
    assertEquals(Wish.NOTHING, hands.take(button(7, 1), USUAL));
  }

  @Test
  void aButtonThatWasDownWhenItWasPluggedInDoesNothing() {
    PadHands hands = new PadHands();

    assertEquals(Wish.NOTHING, hands.take(new PadEvent(true, true, 4, 1), USUAL));
    assertEquals(Wish.NOTHING, hands.take(new PadEvent(true, true, 1, 1), USUAL));
    assertEquals(Optional.empty(), hands.stick());
  }

  @Test
  void eventsAreReadAsTheKernelWritesThem() {
    ByteBuffer bytes = ByteBuffer.allocate(24).order(ByteOrder.nativeOrder());
    bytes.putInt(17).putShort((short) -32767).put((byte) 0x82).put((byte) 1);
    bytes.putInt(18).putShort((short) 1).put((byte) 0x01).put((byte) 200);
    bytes.putInt(19).putShort((short) 1).put((byte) 0x10).put((byte) 0).flip();

    assertEquals(Optional.of(new PadEvent(true, false, 1, -32767)), PadEvent.read(bytes));
    assertEquals(Optional.of(new PadEvent(false, true, 200, 1)), PadEvent.read(bytes));
    assertEquals(Optional.empty(), PadEvent.read(bytes));
  }

  @Test
  void recordedEventsDriveAndTheEndOfTheDeviceStopsAtOnce() throws Exception {
    Path device = Files.write(folder.resolve("js0"), events(4, axis(1, -32767), button(4, 1), button(6, 1)));
    driver.seen(0);
    PadFollower follower = new PadFollower(driver, new Once(device)::mapping, () -> 10 * MS);
    Thread thread = new Thread(follower);
    thread.start();
    thread.join(20_000);

    assertTrue(!thread.isAlive());
    assertEquals(Optional.of(FakeAuthority.YOU), authority.holder(), "it has driven");
    driver.tick(11 * MS);
    assertEquals(0, output.sent().size(), "unplugged before the first tick");
    assertEquals("", driver.look(12 * MS).pad());
  }

  @Test
  void theStopOfAGamepadWorksWithoutItsViewBeingSeen() throws Exception {
    Path device = Files.write(folder.resolve("js0"), events(4, button(1, 1)));

    new PadFollower(driver, new Once(device)::mapping, () -> 10 * MS).run();

    assertTrue(authority.stoppedBy().isPresent());
  }

  @Test
  void whatIsNotSeenIsNotDrivenUntilTheButtonHasBeenUp() {
    driver.pad(new Stick(1, 0), 0);
    driver.tick(MS);
    assertEquals(0, output.sent().size());

    driver.seen(2 * MS);
    driver.pad(new Stick(1, 0), 3 * MS);
    driver.tick(4 * MS);
    assertEquals(0, output.sent().size(), "it was pressed while nobody saw");

    driver.padEnd(5 * MS);
    driver.pad(new Stick(1, 0), 6 * MS);
    driver.tick(7 * MS);
    assertEquals(1, output.sent().size());
    driver.forget();
    driver.tick(60 * MS);
    assertEquals(2, output.sent().size(), "another view of the window may have the keys");

    driver.tick(500 * MS);
    assertEquals(2, output.sent().size(), "it is covered, or the window is");
    assertEquals(1, output.releases());
    driver.seen(501 * MS);
    driver.pad(new Stick(1, 0), 502 * MS);
    driver.tick(503 * MS);
    assertEquals(2, output.sent().size(), "the button is still down");
  }

  @Test
  void afterAStopTheButtonMustHaveBeenUp() {
    driver.seen(0);
    driver.pad(new Stick(1, 0), MS);
    driver.tick(2 * MS);
    driver.stop();
    authority.releaseStop(FakeAuthority.YOU);
    driver.pad(new Stick(1, 0.5), 3 * MS);
    driver.tick(4 * MS);

    assertEquals(1, output.sent().size());
    driver.padEnd(5 * MS);
    driver.pad(new Stick(1, 0.5), 6 * MS);
    driver.tick(7 * MS);
    assertEquals(2, output.sent().size());
  }

  @Test
  void theFirstJoystickIsTheOneOfTheLowestNumber() throws IOException {
    for (String name : new String[]{"js10", "js2", "jsx", "event0"}) {
      Files.createFile(folder.resolve(name));
    }
    assertEquals(Optional.of(folder.resolve("js2")), PadDevice.first(folder));
    assertEquals(Optional.empty(), PadDevice.first(folder.resolve("nowhere")));
  }

  @Test
  void whateverADeviceSaysNothingIsWantedWithoutTheButton() {
    Random random = new Random(5);
    PadHands hands = new PadHands();
    boolean held = false;
    for (int i = 0; i < 20_000; i++) {
      byte[] noise = new byte[8];
      random.nextBytes(noise);
      noise[6] = (byte) (random.nextInt(3) | (random.nextInt(8) == 0 ? 0x80 : 0));
      noise[7] = (byte) random.nextInt(6);
      Optional<PadEvent> event = PadEvent.read(ByteBuffer.wrap(noise));
      event.ifPresent(e -> hands.take(e, USUAL));
      held = event.filter(e -> e.button() && !e.initial() && e.number() == 4).map(e -> e.value() != 0).orElse(held);
      assertEquals(held, hands.stick().isPresent());
      assertTrue(hands.stick().filter(s -> Math.abs(s.forward()) > 1 || Math.abs(s.left()) > 1).isEmpty());
    }
  }

  @Test
  void theMappingIsConfigured() {
    assertEquals(new PadMapping("", 1, 0, 4, 1), PadMapping.of(context.settings().current()));
    context.settings().set("gamepad", "/dev/input/js3");
    context.settings().set("gamepad_dead_man", 6L);
    assertEquals(new PadMapping("/dev/input/js3", 1, 0, 6, 1), PadMapping.of(context.settings().current()));
  }

  /** Wants a device until it has been read to its end once. */
  private static final class Once {
    private final Path device;
    private int asked;

    Once(Path device) {
      this.device = device;
    }

    PadMapping mapping() {
      asked++;
      return new PadMapping(asked > 10 ? "" : device.toString(), 1, 0, 4, 1);
    }
  }

  private static byte[] events(int spare, PadEvent... events) {
    ByteBuffer bytes = ByteBuffer.allocate(events.length * 8 + spare).order(ByteOrder.nativeOrder());
    for (PadEvent event : events) {
      bytes.putInt(0).putShort((short) event.value()).put((byte) (event.button() ? 1 : 2)).put((byte) event.number());
    }
    return bytes.array();
  }

  private static PadEvent axis(int number, int value) {
    return new PadEvent(false, false, number, value);
  }

  private static PadEvent button(int number, int value) {
    return new PadEvent(false, true, number, value);
  }
}
