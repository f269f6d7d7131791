package org.robotui.ui;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.nio.file.Path;
import org.eclipse.swt.graphics.ImageData;
import org.eclipse.swt.graphics.PaletteData;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfEnvironmentVariable;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.api.config.WriteFailure;
import org.robotui.testkit.TestDisplay;

@EnabledIfEnvironmentVariable(named = "DISPLAY", matches = ".+")
class PngFileSwtTest {
  private static final ImageData PICTURE = new ImageData(8, 4, 24, new PaletteData(0xff, 0xff00, 0xff0000));

  @TempDir
  Path folder;

  @Test
  void aPictureIsWritten() throws IOException {
    TestDisplay.get();
    PngFile.write(PICTURE, folder.resolve("a.png"));
    assertEquals(8, new ImageData(folder.resolve("a.png").toString()).width);
  }

  @Test
  void aFullDiskIsSaidWithoutNamesOfClasses() {
    TestDisplay.get();
    IOException e = assertThrows(IOException.class, () -> PngFile.write(PICTURE, Path.of("/dev/full")));
    assertEquals("the disk is full", WriteFailure.reason(e));
  }

  @Test
  void aFolderThatIsNotThereIsSaidSo() {
    TestDisplay.get();
    IOException e = assertThrows(IOException.class, () -> PngFile.write(PICTURE, folder.resolve("none/a.png")));
    assertEquals("its folder is not there", WriteFailure.reason(e));
  }
}
