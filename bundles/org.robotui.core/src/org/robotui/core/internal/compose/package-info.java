/** Puts RUICs together from what a robot offers, and writes them into configurations. */
package org.robotui.core.internal.compose;
