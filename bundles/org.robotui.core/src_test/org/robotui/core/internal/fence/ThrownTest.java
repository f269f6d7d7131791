package org.robotui.core.internal.fence;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.slf4j.LoggerFactory;

class ThrownTest {
  private static final class Hostile extends RuntimeException {
    private static final long serialVersionUID = 1L;

    @Override
    public String getMessage() {
      throw new StackOverflowError();
    }
  }

  @Test
  void aMessageThatThrowsIsReplacedByTheClass() {
    assertEquals(Hostile.class.getName(), Thrown.text(new Hostile()));
  }

  @Test
  void aMessageWithoutEndIsCut() {
    assertTrue(Thrown.text(new IllegalStateException("x".repeat(1_000_000))).length() < 400);
  }

  @Test
  void whoFindsNoMemoryIsNotAccusedOfHavingTakenItAndTheUserReadsHowToGetMore() {
    String text = Thrown.text(new OutOfMemoryError("Java heap space"));
    assertTrue(text.matches("java.lang.OutOfMemoryError: Java heap space, which another may have used up "
        + "\\(RobotUI may take \\d+ MB; ROBOTUI_MEMORY=\\d+[gm] gives it more\\),"), text);
  }

  @Test
  void aLackOfThreadsIsNoLackOfHeap() {
    assertEquals("java.lang.OutOfMemoryError: unable to create native thread, which another may have used up,",
        Thrown.text(new OutOfMemoryError("unable to create native thread")));
  }

  @Test
  void loggingNeverFails() {
    Thrown.log(LoggerFactory.getLogger(ThrownTest.class), "hostile", new Hostile());
  }
}
