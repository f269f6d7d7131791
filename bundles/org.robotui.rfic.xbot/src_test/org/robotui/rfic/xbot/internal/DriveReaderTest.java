package org.robotui.rfic.xbot.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.data.control.Drives;
import org.robotui.data.control.Drives.Drive;
import org.robotui.data.control.Drives.Phase;

class DriveReaderTest {
  @Test
  void eachLineIsADriveAndOthersAreLeftOut() {
    Drive shoulder = new Drive("shoulder", Phase.FAULT, "0x3210\t(DC link)");
    Drive elbow = new Drive("elbow", Phase.ENABLED, "");
    assertEquals(new Drives(List.of(shoulder, elbow)),
        DriveReader.read("fault\tshoulder\t0x3210\t(DC link)\nenabled\telbow\t\nasleep\twrist\tx\nfault\n\n"));
    assertEquals(new Drives(List.of()), DriveReader.read(""));
  }

  @Test
  void drivesThatAreOffExplainHardwareThatDoesNotAnswer() {
    assertEquals(Optional.of("drives are not enabled: shoulder"),
        DriveReader.off(DriveReader.read("disabled\tshoulder\t\nenabled\telbow\t")));
    assertEquals(Optional.empty(), DriveReader.off(DriveReader.read("enabled\telbow\t")));
    assertEquals(Optional.empty(), DriveReader.off(DriveReader.read("silent\tshoulder\t\ndisabled\telbow\t")));
  }
}
