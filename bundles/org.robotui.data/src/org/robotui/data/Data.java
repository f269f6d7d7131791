package org.robotui.data;

/** An immutable value that can travel through a port. Its delivery is declared by {@link Delivery}. */
public interface Data {}
