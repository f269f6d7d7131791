package org.robotui.uic.teleop.internal;

import java.io.EOFException;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.AccessDeniedException;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Optional;
import java.util.function.LongSupplier;
import java.util.function.Supplier;

/**
 * Follows the gamepad of a mapping as long as one is wanted: waits for it, passes on what hands do, and lets go as soon
 * as it is unplugged. Blocks; ends where its thread is interrupted, as core does with the background of a view that
 * ends.
 */
final class PadFollower implements Runnable {
  private static final long PAUSE_MILLIS = 500;

  private final Driver driver;
  private final Supplier<PadMapping> mapping;
  private final LongSupplier nanoTime;

  PadFollower(Driver driver, Supplier<PadMapping> mapping, LongSupplier nanoTime) {
    this.driver = driver;
    this.mapping = mapping;
    this.nanoTime = nanoTime;
  }

  @Override
  public void run() {
    try {
      while (mapping.get().isUsed() && !Thread.currentThread().isInterrupted()) {
        Optional<Path> device = PadDevice.find(mapping.get());
        driver.padState(device.isEmpty() ? "no gamepad" : follow(device.get()));
        Thread.sleep(PAUSE_MILLIS);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } finally {
      driver.padState("");
    }
  }

  /** Until it has gone or is not wanted any more; says why. */
  private String follow(Path device) {
    String wanted = mapping.get().device();
    try (FileChannel channel = FileChannel.open(device, StandardOpenOption.READ)) {
      driver.padState("gamepad");
      PadHands hands = new PadHands();
      ByteBuffer bytes = ByteBuffer.allocateDirect(PadEvent.BYTES);
      read(channel, bytes.clear());
      while (mapping.get().device().equals(wanted)) { // asked after each wait: it may have been put away meanwhile
        PadEvent.read(bytes.flip()).ifPresent(event -> pass(hands.take(event, mapping.get()), hands));
        read(channel, bytes.clear());
      }
      return "";
    } catch (AccessDeniedException e) {
      return "gamepad may not be read";
    } catch (IOException e) {
      return "no gamepad"; // unplugged, or our thread is interrupted
    } finally {
      driver.padEnd(nanoTime.getAsLong());
    }
  }

  private static void read(FileChannel channel, ByteBuffer bytes) throws IOException {
    while (bytes.hasRemaining()) {
      if (channel.read(bytes) < 0) {
        throw new EOFException();
      }
    }
  }

  private void pass(PadHands.Wish wish, PadHands hands) {
    long now = nanoTime.getAsLong();
    switch (wish) {
      case DRIVE -> hands.stick().ifPresent(stick -> driver.pad(stick, now));
      case LET_GO -> driver.padEnd(now);
      case STOP -> driver.stop();
      case NOTHING -> {}
    }
  }
}
