/** Messages of roblets as records of data, and how recordings of them are read. */
package org.robotui.message.roblets;
