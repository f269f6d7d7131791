package org.robotui.ui.display;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.robotui.api.port.SourceId;

class SourceNameTest {
  private static final SourceId LEFT = new SourceId("rt", "ft/left");
  private static final SourceId RIGHT = new SourceId("rt", "ft/right");

  @Test
  void amongOthersWhatAllBeginWithIsLeftOut() {
    assertEquals("left", SourceName.among(LEFT, List.of(LEFT, RIGHT)));
    assertEquals("ft/left", SourceName.among(LEFT, List.of(LEFT, new SourceId("rt", "/imu"))));
    assertEquals("rt/ft/left", SourceName.among(LEFT, List.of(LEFT, new SourceId("other", "ft/left"))));
    assertEquals("left", SourceName.among(LEFT, List.of(LEFT)));
  }
}
