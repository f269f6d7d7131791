package org.robotui.rfic.xbot.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.data.joint.RobotDescription;
import org.robotui.xbot.Answer;

class DescriptionReaderTest {
  @Test
  void putsPiecesTogether() throws IOException {
    RobotDescription read = new DescriptionReader(words -> switch (words) {
      case "describe urdf 0" -> new Answer(true, "10 <robot n\u00e4");
      case "describe urdf 10" -> new Answer(true, "0 me=''/> ");
      case "describe srdf 0" -> new Answer(true, "0 ");
      default -> throw new AssertionError(words);
    }).read("arm", "/opt/share:relative").orElseThrow();
    assertEquals(new RobotDescription("arm", "the control's URDF", "<robot n\u00e4me=''/> ", "", List.of("/opt/share")),
        read);
  }

  @Test
  void offersNothingWhereTheControlDoesNotSayIt() throws IOException {
    assertEquals(Optional.empty(),
        new DescriptionReader(words -> new Answer(false, "The request 'describe' is not known.")).read("arm", ""));
  }

  @Test
  void endsWhereNothingGoesOn() throws IOException {
    assertEquals(Optional.empty(), new DescriptionReader(words -> new Answer(true, "0")).read("arm", ""));
    assertEquals(Optional.empty(), new DescriptionReader(words -> new Answer(true, "7 ")).read("arm", ""));
    assertEquals(Optional.empty(), new DescriptionReader(words -> new Answer(true, "-5 <robot/>")).read("arm", ""));
  }
}
