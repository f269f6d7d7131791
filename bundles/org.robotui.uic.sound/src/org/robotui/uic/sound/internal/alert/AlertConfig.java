package org.robotui.uic.sound.internal.alert;

import java.nio.file.Path;
import java.util.Optional;
import org.robotui.condition.Condition;
import org.robotui.uic.sound.internal.tone.Sound;

/**
 * An alert as it was configured.
 *
 * @param name what users read
 * @param when the condition as it was written
 * @param condition when it is due
 * @param sound what is heard
 * @param volume 0 to 1
 * @param words what is spoken after the sound; empty for nothing
 * @param forNanos how long the condition must hold before
 * @param repeatNanos how often the sound is heard while it holds; 0 for once
 * @param muted whether it is only written to the log
 * @param script what is run when it begins
 */
public record AlertConfig(
    String name, String when, Condition condition, Sound sound, double volume, String words, long forNanos,
    long repeatNanos,
    boolean muted, Optional<Path> script) {}
