package org.robotui.uic.sound.internal.tone;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.lang.reflect.Proxy;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import javax.sound.sampled.AudioFileFormat;
import javax.sound.sampled.AudioFormat;
import javax.sound.sampled.AudioInputStream;
import javax.sound.sampled.AudioSystem;
import javax.sound.sampled.LineUnavailableException;
import javax.sound.sampled.SourceDataLine;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class LineSpeakerTest {
  private final List<String> called = new ArrayList<>();
  private final ByteArrayOutputStream written = new ByteArrayOutputStream();

  @Test
  void aSoundIsWrittenAsSixteenBitsAndTheLineGivenBack() throws Exception {
    Pcm beep = Tone.BEEP.sound();
    new LineSpeaker(this::line).play(beep, 0.7);
    assertArrayEquals(beep.bytes(0.7), written.toByteArray());
    assertEquals("open", called.getFirst());
    assertEquals("close", called.getLast());
  }

  @Test
  void aDeviceThatIsInUseIsAReason() {
    LineSpeaker speaker = new LineSpeaker(format -> {
      throw new LineUnavailableException("in use");
    });
    Exception e = assertThrows(SilentException.class, () -> speaker.play(Tone.BEEP.sound(), 1));
    assertEquals("no audio device takes 44100 Hz (in use); connect one, or let this user use it", e.getMessage());
  }

  @Test
  void anInterruptEndsTheSoundAndClosesTheLine() {
    Thread.currentThread().interrupt();
    assertThrows(InterruptedException.class, () -> new LineSpeaker(this::line).play(Tone.ALARM.sound(), 1));
    assertEquals("close", called.getLast());
    assertEquals(0, written.size());
  }

  @Test
  void aFileIsReadWithItsChannelsAsOne(@TempDir Path folder) throws Exception {
    Path file = folder.resolve("two.wav");
    byte[] left16384Right0 = {0, 64, 0, 0, 0, 64, 0, 0};
    write(file, left16384Right0);
    Pcm pcm = WavFile.read(file);
    assertEquals(22_050, pcm.rate());
    assertEquals(2, pcm.samples().length);
    assertEquals(0.25, pcm.samples()[0], 0.001);
  }

  @Test
  void whatIsNoSoundIsRefusedWithItsName(@TempDir Path folder) throws IOException {
    Path file = Files.writeString(folder.resolve("text.wav"), "RIFF and nothing else that would be of use to anybody");
    Exception e = assertThrows(SilentException.class, () -> WavFile.read(file));
    assertTrue(e.getMessage().contains("text.wav"), e.getMessage());
  }

  private static void write(Path file, byte[] frames) throws IOException {
    AudioFormat format = new AudioFormat(22_050, 16, 2, true, false);
    try (AudioInputStream stream = new AudioInputStream(new ByteArrayInputStream(frames), format, frames.length / 4)) {
      AudioSystem.write(stream, AudioFileFormat.Type.WAVE, file.toFile());
    }
  }

  private SourceDataLine line(AudioFormat format) {
    return (SourceDataLine) Proxy.newProxyInstance(getClass().getClassLoader(), new Class<?>[]{SourceDataLine.class},
        (proxy, method, arguments) -> {
          called.add(method.getName());
          return switch (method.getName()) {
            case "write" -> written((byte[]) arguments[0], (int) arguments[1], (int) arguments[2]);
            case "getFormat" -> format;
            case "getLongFramePosition" -> (long) written.size() / 2;
            default -> null;
          };
        });
  }

  private int written(byte[] bytes, int from, int count) {
    written.write(bytes, from, count);
    return count;
  }
}
