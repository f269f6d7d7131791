package org.robotui.ui.ask;

import java.time.Duration;
import java.time.Instant;
import java.util.Optional;
import org.robotui.data.record.DynamicRecord;
import org.robotui.ui.Health;

/**
 * A question and what has become of it so far.
 *
 * @param number counts the questions of a view
 * @param entry what was asked
 * @param at when, by this machine's clock
 * @param running whether the answer is still awaited
 * @param health how it goes, or went
 * @param words a sentence on that
 * @param took how long it takes, or took
 * @param feedback what the robot said last on its way
 * @param result what came back
 */
public record Asked(long number, Catalogue.Entry entry, Instant at, boolean running, Health health, String words,
    Duration took,
    Optional<DynamicRecord> feedback, Optional<DynamicRecord> result) {}
