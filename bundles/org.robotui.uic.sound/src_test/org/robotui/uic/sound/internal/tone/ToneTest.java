package org.robotui.uic.sound.internal.tone;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class ToneTest {
  @Test
  void aBeepHasItsPitchAndLittleElse() {
    float[] beep = Tone.BEEP.sound().samples();
    assertTrue(level(beep, 880, 0, beep.length) > 0.4);
    assertTrue(level(beep, 880, 0, beep.length) > 4 * level(beep, 1760, 0, beep.length));
    assertTrue(level(beep, 1000, 0, beep.length) < 0.02);
    assertTrue(level(beep, 440, 0, beep.length) < 0.02);
  }

  @Test
  void anAlarmChangesItsPitch() {
    float[] alarm = Tone.ALARM.sound().samples();
    int part = Tone.RATE / 5;
    assertTrue(level(alarm, 960, 0, part) > 10 * level(alarm, 770, 0, part));
    assertTrue(level(alarm, 770, part, 2 * part) > 10 * level(alarm, 960, part, 2 * part));
  }

  @Test
  void aChimeFades() {
    float[] chime = Tone.CHIME.sound().samples();
    int quarter = chime.length / 4;
    assertTrue(loudness(chime, 0, quarter) > 4 * loudness(chime, 3 * quarter, chime.length));
  }

  @ParameterizedTest
  @EnumSource(Tone.class)
  void noSoundClipsClicksOrIsSilent(Tone tone) {
    float[] samples = tone.sound().samples();
    double peak = 0;
    double steepest = Math.max(Math.abs(samples[0]), Math.abs(samples[samples.length - 1]));
    for (int i = 1; i < samples.length; i++) {
      peak = Math.max(peak, Math.abs(samples[i]));
      steepest = Math.max(steepest, Math.abs(samples[i] - samples[i - 1]));
    }
    assertTrue(peak > 0.3 && peak < 1, "peak " + peak);
    assertTrue(steepest < 0.2, "a step of " + steepest);
    assertTrue(tone.sound().seconds() < 2);
  }

  @Test
  void theVolumeScalesTheBytes() {
    Pcm pcm = new Pcm(new float[]{0.5f, -1, 2}, Tone.RATE);
    assertEquals("[0, 64, 1, -128, -1, 127]", Arrays.toString(pcm.bytes(1)));
    assertEquals("[0, 32, 1, -64, -1, 127]", Arrays.toString(pcm.bytes(0.5)));
    assertEquals("[0, 0, 0, 0, 0, 0]", Arrays.toString(pcm.bytes(0)));
  }

  @Test
  void wordsAndFilesAreSoundsAndNothingElse() {
    assertEquals(new Sound.Made(Tone.CHIME), Sound.parse("chime"));
    assertTrue(Sound.parse("/opt/sounds/horn.WAV") instanceof Sound.File);
    Exception e = assertThrows(IllegalArgumentException.class, () -> Sound.parse("bell"));
    assertEquals("there is no sound 'bell'; write one of beep, chime, alarm, or the path of a .wav file",
        e.getMessage());
  }

  /** How much of a pitch there is, as an amplitude. */
  private static double level(float[] samples, double hertz, int from, int to) {
    double re = 0;
    double im = 0;
    for (int i = from; i < to; i++) {
      double angle = 2 * Math.PI * hertz * i / Tone.RATE;
      re += samples[i] * Math.cos(angle);
      im += samples[i] * Math.sin(angle);
    }
    return 2 * Math.hypot(re, im) / (to - from);
  }

  private static double loudness(float[] samples, int from, int to) {
    double sum = 0;
    for (int i = from; i < to; i++) {
      sum += samples[i] * samples[i];
    }
    return Math.sqrt(sum / (to - from));
  }
}
