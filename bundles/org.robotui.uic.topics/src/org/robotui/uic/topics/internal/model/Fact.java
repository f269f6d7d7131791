package org.robotui.uic.topics.internal.model;

import java.util.Optional;

/**
 * Something known about a thing.
 *
 * @param number its place, which identifies it
 * @param label what it is, empty where it goes on from the line before
 * @param value the words
 * @param target the thing that the words name, where there is one
 */
public record Fact(int number, String label, String value, Optional<Key> target) {}
