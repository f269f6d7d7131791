/**
 * Player's interfaces as Java records in SI units: for each interface a class with its messages, and the records they
 * carry. Arrays in records are not to be changed.
 */
package org.robotui.player.interfaces;
