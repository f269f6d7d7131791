package org.robotui.uic.log.internal.model;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class PauseTest {
  private final Log log = new Log();

  @Test
  void duringAPauseTheListStandsAndWhatComesIsCounted() {
    log.info("one").tick();
    log.model.pause(true);
    log.tick();
    assertEquals(List.of("one"), log.info("two", "three").messages());
    assertEquals(2, log.model.current().held());
    log.model.pause(false);
    assertEquals(List.of("one", "two", "three"), log.messages());
    assertEquals(0, log.model.current().held());
  }

  @Test
  void duringAPauseTheFilterWorksOnWhatIsHeld() {
    log.info("one", "two").tick();
    log.model.pause(true);
    log.tick();
    log.info("two again").tick();
    log.model.filter(LogFilter.ALL.search(Search.of("two", false)));
    assertEquals(List.of("two"), log.messages());
  }

  @Test
  void whatIsReadDuringAPauseIsNotPushedOutAtOnce() {
    log.capacity = 1000;
    IntStream.range(0, 1000).forEach(i -> log.info("m" + i));
    log.tick();
    log.model.pause(true);
    log.tick();
    IntStream.range(0, 1000).forEach(i -> log.info("n" + i));
    assertEquals("m0", log.messages().getFirst());
    IntStream.range(0, 5000).forEach(i -> log.info("o" + i));
    assertEquals(List.of(), log.messages(), "but the memory stays bounded");
    assertEquals(2000, log.model.current().kept());
  }

  @Test
  void clearingDuringAPauseClearsAndHoldsOn() {
    log.info("one").tick();
    log.model.pause(true);
    log.tick();
    log.model.clear();
    assertEquals(List.of(), log.info("two").messages());
    log.model.pause(false);
    assertEquals(List.of("two"), log.messages());
  }
}
